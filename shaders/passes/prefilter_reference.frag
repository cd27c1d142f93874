#version 450 core
// What shaders/passes/prefilter.frag approximates, for a row of directions and any number of samples.
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 6) uniform samplerCube environment;
layout(binding = 8) uniform samplerBuffer directions;   // unit, one a pixel
layout(binding = 9) uniform samplerBuffer lobe;         // as prefilter.frag's lobeSamples
uniform int sampleCount;
uniform float sharper;     // levels below the one whose texels would just tile the lobe

void main() {
  vec3 N = texelFetch(directions, int(gl_FragCoord.x)).xyz;
  vec3 T = normalize(abs(N.z) < 0.9 ? cross(vec3(0.0, 0.0, 1.0), N) : cross(vec3(1.0, 0.0, 0.0), N));
  vec3 B = cross(N, T);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < sampleCount; ++i) {
    vec4 l = texelFetch(lobe, i);
    sum += textureLod(environment, l.x * T + l.y * B + l.z * N, max(l.w - sharper, 0.0)).rgb;
  }
  outColor = vec4(sum / float(sampleCount), 1.0);
}
