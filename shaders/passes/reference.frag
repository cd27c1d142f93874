#version 450 core
// Light on the G-buffer for one shading model, as shaders/passes/lighting.frag but by Monte Carlo: some samples a draw,
// which are added up. Lights without a surface are exact.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/shading.glsl"
#include "shaders/common/output.glsl"
#pragma glint model

layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
#include "shaders/common/shaded_pixel.glsl"
#include "shaders/common/lights.glsl"
#include "shaders/common/scene_lights.glsl"
#ifdef SPLIT_SUM
// Of the environment only the diffuse part is as it is.
bool diffuseAlone = false;
vec3 partLit(Shading s, Parameters p) { return diffuseAlone ? modelDiffuse(s, p) : modelLit(s, p); }
#define REFERENCE_LIT partLit
#endif
#include "shaders/common/reference.glsl"
#if defined(ENVIRONMENT) || defined(FURNACE)
#include "shaders/common/reference_environment.glsl"
#endif

uniform int firstSample, sampleCount;
uniform float share;       // of the picture that this draw is
uniform float environmentScale;   // by which view.environmentIntensity is too small for the environment itself

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Surface surface;
  Shading s;
  Parameters p;
  shadePixel(pixel, surface, s, p);
  uvec3 offset = referenceHash(uvec3(pixel, 0u));

  vec3 radiance = directionalLights(s, p);
#if defined(POINT_LIGHTS) || defined(PLACED_LIGHTS)
  vec3 position = worldPosition(gl_FragCoord.xy, texelFetch(gDepth, pixel, 0).r);
  int texel = inLights.x;
#endif
#ifdef POINT_LIGHTS
  radiance += pointLights(s, p, position, texel, inLights.y);
  texel += inLights.y * kPointLightTexels;
#endif
  Proposal q = referenceProposal(s, p);
#ifdef PLACED_LIGHTS
  int upToSpots = inLights.z & 0xffff, upToSpheres = upToSpots + (inLights.z >> 16), upToTubes = upToSpheres + (inLights.w & 0xffff);
  for (int i = 0; i < upToTubes + (inLights.w >> 16); ++i, texel += kPlacedLightTexels) {
    int kind = i < upToSpots ? kSpotLight : i < upToSpheres ? kSphereLight : i < upToTubes ? kTubeLight : kRectangleLight;
    PlacedLight light = placedLightAt(texel, kind, position);
    float falloff = attenuation(light);
    if (falloff <= 0.0) continue;
    vec3 lit;
    if (light.kind == kSpotLight) {
      float distance2 = max(dot(light.center, light.center), 1e-12);
      vec3 L = light.center * inversesqrt(distance2);
      lit = referenceSentOn(s, p, L) * (spotProfile(light, L) / distance2);
    } else {
      offset = referenceHash(offset);
      lit = referenceLight(light, s, p, q, uint(firstSample), sampleCount, offset);
    }
    radiance += lit * texelFetch(tileLights, texel + 1).rgb * falloff;
  }
#endif
#if defined(ENVIRONMENT) || defined(FURNACE)
  s.analyticLight = false;
  modelPrepare(s, p);
#ifdef SPLIT_SUM
  diffuseAlone = true;
  radiance += referenceSplitSum(s, p, q, uint(firstSample), sampleCount, referenceHash(offset + 1u)) * (surface.ambientOcclusion * view.environmentIntensity * environmentScale);
#endif
  radiance += referenceEnvironment(s, p, q, uint(firstSample), sampleCount, referenceHash(offset)) * (surface.ambientOcclusion * view.environmentIntensity * environmentScale);
#endif
  radiance *= surface.cavity;
#ifdef EMISSIVE
  radiance += texelFetch(gEmissive, pixel, 0).rgb;
#endif
  vec4 color = outputColor(radiance);
  outColor = referenceSound ? color * share : vec4(color.rgb * share, 0.0);
}
