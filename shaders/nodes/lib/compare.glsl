// 1 in each component that is 0.
float equal_zero(float x) { return x == 0.0 ? 1.0 : 0.0; }
vec2 equal_zero(vec2 x) { return vec2(equal(x, vec2(0.0))); }
vec3 equal_zero(vec3 x) { return vec3(equal(x, vec3(0.0))); }
vec4 equal_zero(vec4 x) { return vec4(equal(x, vec4(0.0))); }

// x with its sign, but at least `least` away from 0: for a divisor.
float abs_at_least(float x, float least) { return x < 0.0 ? min(x, -least) : max(x, least); }
vec2 abs_at_least(vec2 x, float least) { return mix(max(x, vec2(least)), min(x, vec2(-least)), lessThan(x, vec2(0.0))); }
vec3 abs_at_least(vec3 x, float least) { return mix(max(x, vec3(least)), min(x, vec3(-least)), lessThan(x, vec3(0.0))); }
vec4 abs_at_least(vec4 x, float least) { return mix(max(x, vec4(least)), min(x, vec4(-least)), lessThan(x, vec4(0.0))); }
