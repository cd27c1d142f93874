#version 450 core
// One level of the prefiltered environment: the average under a lobe around each texel's direction. The lobe comes
// as directions drawn from it by renderer/lobe.cpp, each with the level whose texels are as large as the solid angle
// it stands for (Krivanek and Colbert 2008), so that few samples see every texel. What is too small and bright for them is
// not in the environment but in a list of directions, which the lobe is evaluated for.
#include "shaders/common/cube.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 6) uniform samplerCube environment;
layout(binding = 7) uniform sampler2D density;   // of the lobe, per steradian, over the root of its angle: lobeAngle() of renderer/lobe.h
layout(std140, binding = 4) uniform LobeSamples { vec4 lobeSamples[4096]; };  // xyz around +Z, w: level
layout(std140, binding = 5) uniform Spots { vec4 spotDirections[128], spotIrradiances[128]; };
uniform int face, sampleCount, spotCount;
uniform float size;
uniform float scale;       // EnvironmentMaps::scale

void main() {
  vec3 N = normalize(cubeDirection(face, gl_FragCoord.xy / size));
  vec3 T = normalize(abs(N.z) < 0.9 ? cross(vec3(0.0, 0.0, 1.0), N) : cross(vec3(1.0, 0.0, 0.0), N));
  vec3 B = cross(N, T);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < sampleCount; ++i) {
    vec4 l = lobeSamples[i];
    sum += textureLod(environment, l.x * T + l.y * B + l.z * N, l.w).rgb;
  }
  vec3 mean = sum / float(sampleCount);
  for (int i = 0; i < spotCount; ++i) {
    // By the chord: a cosine near 1 has lost the angle.
    float halfSine = 0.5 * distance(N, spotDirections[i].xyz);
    if (halfSine >= 0.70710678) continue;
    float u = sqrt(2.0 * asin(halfSine) / 1.57079632679);
    mean += spotIrradiances[i].rgb * (scale * textureLod(density, vec2(u, 0.5), 0.0).r);
  }
  outColor = vec4(min(mean, vec3(65504.0)), 1.0);
}
