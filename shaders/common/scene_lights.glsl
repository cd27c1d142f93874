// The lights of a view, and what a model sends on of those that have one direction. After the model's own text and
// view.glsl; POINT_LIGHTS and PLACED_LIGHTS say which others there are.
struct DirectionalLight {
  vec4 direction;  // towards the light; w: the number of its shadow, 0 without
  vec4 radiance;   // lux: E = radiance NoL
};
layout(std140, binding = 2) uniform DirectionalLights { DirectionalLight directional[16]; };

#include "shaders/common/visibility.glsl"

vec3 directionalLights(inout Shading s, Parameters p) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < view.directionalCount; ++i) {
    vec3 L = directional[i].direction.xyz;
    setLight(s, L);
    vec3 radiance = directional[i].radiance.rgb * lightVisibility(directional[i].direction.w);
    sum += modelLit(s, p) * radiance * max(dot(s.N, L), 0.0);
    if (modelScatters) sum += modelScattered(s, p) * radiance;
  }
  return sum;
}

#if defined(POINT_LIGHTS) || defined(PLACED_LIGHTS)
#include "shaders/common/lights.glsl"
// In the order of the tiles' lists, PointBlock and PlacedBlock of renderer/prepared_view.h. A texture, because software GL reads those eight pixels at a time and storage buffers one by one.
layout(binding = 8) uniform samplerBuffer tileLights;
const int kPointLightTexels = 2;

vec3 pointLights(inout Shading s, Parameters p, vec3 position, int texel, int count) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < count; ++i, texel += kPointLightTexels) {
    vec4 lightPosition = texelFetch(tileLights, texel), intensity = texelFetch(tileLights, texel + 1);
    vec3 toLight = lightPosition.xyz - position;
    float distance2 = dot(toLight, toLight);
    vec3 L = toLight * inversesqrt(max(distance2, 1e-12));
    float falloff = windowedFalloff(distance2, lightPosition.w, intensity.w);
    setLight(s, L);
    sum += modelLit(s, p) * (intensity.rgb * (falloff * max(dot(s.N, L), 0.0)));
    if (modelScatters) sum += modelScattered(s, p) * (intensity.rgb * falloff);
  }
  return sum;
}

PlacedLight placedLightAt(int texel, int kind, vec3 position) {
  vec4 at = texelFetch(tileLights, texel), along = texelFetch(tileLights, texel + 2), up = texelFetch(tileLights, texel + 3);
  return PlacedLight(kind, at.xyz - position, at.w, texelFetch(tileLights, texel + 1).w, along.xyz, up.xyz, vec2(along.w, up.x));
}
// The number of its shadow.
float placedShadowAt(int texel) { return texelFetch(tileLights, texel + 3).w; }
#endif
