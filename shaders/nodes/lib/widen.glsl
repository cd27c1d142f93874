// Components that are not there are 0.
vec4 widened(float x) { return vec4(x, 0.0, 0.0, 0.0); }
vec4 widened(vec2 x) { return vec4(x, 0.0, 0.0); }
vec4 widened(vec3 x) { return vec4(x, 0.0); }
vec4 widened(vec4 x) { return x; }
