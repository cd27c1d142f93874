#version 450 core
// Makes the occlusion of half resolution smooth, where it lies on one surface; with WHOLE it also brings it to every pixel.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/screen.glsl"
layout(location = 0) flat in ivec4 inLights;
#ifdef WHOLE
layout(location = 0) out float outOcclusion;
#else
layout(location = 0) out vec2 outOcclusion;
#endif
layout(binding = 16) uniform sampler2D halfOcclusion;
uniform float radius;
uniform ivec2 halfOffset;

vec2 atTexel(ivec2 texel) { return texelFetch(halfOcclusion, clamp(texel, ivec2(0), textureSize(halfOcclusion, 0) - 1), 0).xy; }
vec2 pixelOf(ivec2 texel) { return vec2(clamp(texel * 2 + halfOffset, viewRectangle.xy, viewRectangle.zw - 1)) + 0.5; }

// The distance of worldAtDepth(pixel, depth) from a plane is origin.xyz (1, pixel) + depth ray.xyz (1, pixel).
struct Plane { vec3 origin, ray; };
Plane planeAt(vec3 P, vec3 N) {
  return Plane(vec3(dot(N, view.rayOrigin.xyz - P), dot(N, view.originX.xyz), dot(N, view.originY.xyz)),
               vec3(dot(N, view.rayDirection.xyz), dot(N, view.rayX.xyz), dot(N, view.rayY.xyz)));
}
// By how far the other lies from the plane of this one.
float alike(Plane plane, ivec2 texel, vec2 other) {
  vec3 pixel = vec3(1.0, pixelOf(texel));
  return other.y > 0.0 ? clamp(1.0 - abs(dot(plane.origin, pixel) + other.y * dot(plane.ray, pixel)) / (0.05 * radius), 0.0, 1.0) : 0.0;
}

void main() {
#ifdef WHOLE
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = linearDepth(texelFetch(gDepth, pixel, 0).r);
  Plane plane = planeAt(worldAtDepth(gl_FragCoord.xy, depth), normalize(texelFetch(gNormal, pixel, 0).xyz));
  vec2 at = 0.5 * vec2(pixel - halfOffset);
  ivec2 low = ivec2(floor(at));
  vec2 part = at - vec2(low);
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 side = mix(1.0 - part, part, vec2(corner)) + 0.01, other = atTexel(low + corner);
    float weight = side.x * side.y * (alike(plane, low + corner, other) + 1e-4 * float(other.y > 0.0));
    sum += weight * other.x;
    weights += weight;
  }
  outOcclusion = weights > 0.0 ? sum / weights : 1.0;
#else
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec2 own = atTexel(texel);
  vec2 at = pixelOf(texel);
  Plane plane = planeAt(worldAtDepth(at, own.y), normalize(texelFetch(gNormal, ivec2(at), 0).xyz));
  float sum = 1e-6 * own.x, weights = 1e-6;
  for (int y = -2, end = own.y > 0.0 ? 2 : -2; y < end; ++y)
    for (int x = -2; x < 2; ++x) {
      vec2 other = atTexel(texel + ivec2(x, y));
      float weight = alike(plane, texel + ivec2(x, y), other);
      sum += weight * other.x;
      weights += weight;
    }
  outOcclusion = vec2(sum / weights, own.y);
#endif
}
