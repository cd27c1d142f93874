#include "shaders/common/gbuffer.glsl"
layout(binding = 0) uniform sampler2D gBaseColor;
layout(binding = 1) uniform sampler2D gNormal;
layout(binding = 2) uniform sampler2D gMaterial;
layout(binding = 3) uniform sampler2D gEmissive;
layout(binding = 4) uniform sampler2D gParameters;
layout(binding = 5) uniform sampler2D gDepth;
layout(binding = 9) uniform sampler2D gTangent;

Surface readSurface(ivec2 pixel) {
  vec4 a = texelFetch(gBaseColor, pixel, 0), b = texelFetch(gNormal, pixel, 0), c = texelFetch(gMaterial, pixel, 0);
  return Surface(a.rgb, a.a, normalize(b.xyz), b.a, c.r, c.g, c.b, c.a * 255.0);
}

// The tangent of the surface, unit and perpendicular to its normal.
vec3 readTangent(ivec2 pixel, vec3 N) {
  float turn = 3.14159265 * texelFetch(gTangent, pixel, 0).r;
  vec3 T = anyTangent(N);
  return cos(turn) * T + sin(turn) * cross(N, T);
}
