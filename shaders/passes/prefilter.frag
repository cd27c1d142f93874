#version 450 core
// One level of the prefiltered environment: the average under a lobe around each texel's direction. The lobe comes
// as directions drawn from it by renderer/lobe.cpp, each with the level whose texels are as large as the solid angle
// it stands for (Krivanek and Colbert 2008), so that few samples see every texel.
#include "shaders/common/cube.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 6) uniform samplerCube environment;
layout(std140, binding = 4) uniform LobeSamples { vec4 lobeSamples[4096]; };  // xyz around +Z, w: level
uniform int face, sampleCount;
uniform float size;

void main() {
  vec3 N = normalize(cubeDirection(face, gl_FragCoord.xy / size));
  vec3 T = normalize(abs(N.z) < 0.9 ? cross(vec3(0.0, 0.0, 1.0), N) : cross(vec3(1.0, 0.0, 0.0), N));
  vec3 B = cross(N, T);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < sampleCount; ++i) {
    vec4 l = lobeSamples[i];
    sum += textureLod(environment, l.x * T + l.y * B + l.z * N, l.w).rgb;
  }
  outColor = vec4(sum / float(sampleCount), 1.0);
}
