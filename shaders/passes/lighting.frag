#version 450 core
// Light on the G-buffer, for one shading model: the stencil lets only its pixels through.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/shading.glsl"
#include "shaders/common/output.glsl"
#pragma glint model

layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
#include "shaders/common/shaded_pixel.glsl"
#include "shaders/common/scene_lights.glsl"
#ifdef GROUND
#include "shaders/common/backdrop.glsl"
#endif

#ifdef ENVIRONMENT
layout(binding = 6) uniform samplerCube prefilteredEnvironment;
// Where the one lobe of a model stands that does not read the roughness: EnvironmentLighting::kOwnLobeLevel.
const float kOwnLobeLevel = 1.0;
layout(binding = 7) uniform sampler2D environmentBrdf;  // x: NoV, y: roughness
layout(binding = 18) uniform samplerCube irradianceCube;
// Spherical harmonics of E / pi; in the first one's w is 1 where irradianceCube has it instead: see renderer/environment_irradiance.h.
layout(std140, binding = 3) uniform EnvironmentData { vec4 irradiance[9]; };

// Ramamoorthi and Hanrahan 2001; the constants of the basis are folded into the coefficients.
vec3 diffuseIrradiance(vec3 n) {
  if (irradiance[0].w != 0.0) return textureLod(irradianceCube, n, 0.0).rgb;
  vec3 e = irradiance[0].rgb + irradiance[1].rgb * n.y + irradiance[2].rgb * n.z + irradiance[3].rgb * n.x +
           irradiance[4].rgb * (n.x * n.y) + irradiance[5].rgb * (n.y * n.z) +
           irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) + irradiance[7].rgb * (n.x * n.z) +
           irradiance[8].rgb * (n.x * n.x - n.y * n.y);
  return max(e, 0.0);
}

// Scale on F0 and bias of the specular part, albedo of the diffuse part over Lambert's. Models without colours of their
// own have the three in one texel; COLORED_BRDF has a table for each, one above the other.
// And the largest albedo of facets that reflect all.
struct EnvironmentBrdf { vec3 scale, bias, diffuse; float white; };
const float kBrdfSize = 64.0;  // EnvironmentLighting::kBrdfSize: the outermost texels stand on 0 and 1
EnvironmentBrdf coloredBrdfAt(sampler2D table, float NoV, float roughness) {
  vec2 texel = vec2(NoV, roughness) * (kBrdfSize - 1.0) + 0.5, size = vec2(kBrdfSize, 3.0 * kBrdfSize);
  vec4 bias = textureLod(table, (texel + vec2(0.0, kBrdfSize)) / size, 0.0);
  return EnvironmentBrdf(textureLod(table, texel / size, 0.0).rgb, bias.rgb,
                         textureLod(table, (texel + vec2(0.0, 2.0 * kBrdfSize)) / size, 0.0).rgb, bias.w);
}
EnvironmentBrdf environmentBrdfAt(float NoV, float roughness) {
#ifdef COLORED_BRDF
  return coloredBrdfAt(environmentBrdf, NoV, roughness);
#else
  vec4 table = textureLod(environmentBrdf, (vec2(NoV, roughness) * (kBrdfSize - 1.0) + 0.5) / kBrdfSize, 0.0);
  return EnvironmentBrdf(vec3(table.x), vec3(table.y), vec3(table.z), table.w);
#endif
}

// What of a lobe's light arrives where `open` of the hemisphere's does (Lagarde and de Rousiers 2014, listing 26).
float specularOpenness(float NoV, float open, float roughness) {
  return clamp(pow(NoV + open, exp2(-16.0 * roughness - 1.0)) - 1.0 + open, 0.0, 1.0);
}

// Inverse of EnvironmentLighting::levelRoughness.
float levelOf(float roughness) { return view.environmentLevels * roughness * (1.7 - 0.7 * roughness); }

#ifdef MODEL_TANGENT
// By how much the model's lobe is wider than the one the cube was filtered with, as slopes of the half vector along
// the tangent and the bitangent, for each level.
uniform vec2 lobeStretch[6];

// A wide lobe is a row of narrow ones: half vectors at the quantiles of the slopes of GGX.
vec3 stretchedLight(Shading s, float level) {
  const int kRow = 8;
  int below = int(level);
  vec2 slope = mix(lobeStretch[below], lobeStretch[min(below + 1, 5)], level - float(below));
  vec3 axis = slope.x * s.T + slope.y * s.B;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < kRow; ++i) {
    float u = (2.0 * float(i) + 1.0) / float(kRow) - 1.0;
    vec3 H = normalize(s.N + u * inversesqrt(1.0 - u * u) * axis);
    vec3 L = 2.0 * dot(s.V, H) * H - s.V;
    sum += vec4(textureLod(prefilteredEnvironment, environmentFromWorld(L), level).rgb, 1.0) * max(dot(s.N, L), 1e-4);
  }
  return sum.rgb / sum.a;
}
#endif

#ifdef MODEL_COAT
layout(binding = 11) uniform samplerCube prefilteredCoat;
layout(binding = 12) uniform sampler2D coatBrdf;
#endif
#endif

#ifdef PLACED_LIGHTS
// AreaLights::Cosines of renderer/renderer.h, for models whose lobe is the same all around.
#if PLACED_LIGHTS == 5 && !defined(MODEL_TANGENT) && !defined(MODEL_IS_WHOLE)
#define COSINES
#include "shaders/common/linearly_transformed_cosines.glsl"
layout(binding = 10) uniform sampler2DArray areaLightTable;  // renderer/area_light_tables.h
struct Reflection { CosineLobe lobe; vec3 reflected; };
Reflection reflectionAt(Shading s, float roughness, float layer) {
  vec2 size = vec2(textureSize(areaLightTable, 0).xy), at = (vec2(sqrt(max(1.0 - s.NoV, 0.0)), roughness) * (size - 1.0) + 0.5) / size;
  return Reflection(cosineLobe(s.N, s.V, textureLod(areaLightTable, vec3(at, layer), 0.0)),
                    s.F0 * textureLod(areaLightTable, vec3(at, layer + 1.0), 0.0).rgb + textureLod(areaLightTable, vec3(at, layer + 2.0), 0.0).rgb);
}
// What of a surface is the same for all lights.
struct Receiver {
  Reflection base;
#ifdef MODEL_COAT
  Reflection coat;
#endif
};
Receiver receiver(Shading s, Parameters p) {
  Receiver r;
  r.base = reflectionAt(s, s.roughness, 0.0);
#ifdef MODEL_COAT
  r.coat = reflectionAt(s, clamp(modelCoatRoughness(p), 0.0, 1.0), 3.0);
#endif
  return r;
}
#endif

// What a model sends on of a light of 1 candela, by a representative point.
vec3 placedLight(PlacedLight light, Shading s, Parameters p) {
  float falloff = attenuation(light);
  if (falloff <= 0.0) return vec3(0.0);
  vec3 lit = vec3(0.0);
  Arrival arrival = representativePoint(light, s, PLACED_LIGHTS);
  setLight(s, arrival.specularL);
  if (dot(s.N, s.L) > 0.0) {
#ifdef MODEL_IS_WHOLE
    lit = modelLit(s, p) * arrival.specular;
#else
    if (arrival.widened > 0.0 && modelHasParts) {
      Shading wide = s;
      setRoughness(wide, sqrt(arrival.widened));
      lit = (modelD(wide, p) * modelV(s, p)) * modelF(s, p) * arrival.specular;
    } else {
      lit = modelSpecular(s, p) * arrival.specular;
    }
#endif
  }
  setLight(s, arrival.diffuseL);
#ifndef MODEL_IS_WHOLE
  lit += modelDiffuse(s, p) * arrival.irradiance;
#endif
  if (modelScatters) lit += modelScattered(s, p) / max(dot(light.center, light.center), 1e-12);
  return lit * falloff;
}

#ifdef COSINES
// Likewise of two, by its lobe.
struct Lit { vec3 one, two; };
vec3 litFrom(vec3 center, float irradiance, Shading s, Parameters p) {
  setLight(s, normalize(center));
  vec3 lit = modelDiffuse(s, p) * irradiance;
#ifdef COMPENSATE
  lit += glintFurtherBounces(s, p.glintBounces) * irradiance;
#endif
  if (modelScatters) lit += modelScattered(s, p) / max(dot(center, center), 1e-12);
  return lit;
}
Lit areaLights(PlacedLight one, PlacedLight two, Receiver receiver, Shading s, Parameters p) {
  Lit lit;
#ifdef MODEL_COAT
  Seen seen = seenLights(one, two, s.N, receiver.base.lobe, receiver.coat.lobe);
  // A coat lets through what its half vector says.
  setLight(s, normalize(one.center));
  lit.one = modelThroughCoat(s, p) * (receiver.base.reflected * seen.specular.x) + modelCoatStrength(p) * (receiver.coat.reflected * seen.coat.x);
  setLight(s, normalize(two.center));
  lit.two = modelThroughCoat(s, p) * (receiver.base.reflected * seen.specular.y) + modelCoatStrength(p) * (receiver.coat.reflected * seen.coat.y);
#else
  Seen seen = seenLights(one, two, s.N, receiver.base.lobe, receiver.base.lobe);
  lit = Lit(receiver.base.reflected * seen.specular.x, receiver.base.reflected * seen.specular.y);
#endif
  lit.one = (max(lit.one, 0.0) / kPi + litFrom(one.center, seen.irradiance.x, s, p)) * attenuation(one);
  lit.two = (max(lit.two, 0.0) / kPi + litFrom(two.center, seen.irradiance.y, s, p)) * attenuation(two);
  return lit;
}
#endif
#endif

// What the surface under a pixel sends to the viewer of the light that arrives, apart from its cavity.
vec3 sentOn(ivec2 pixel, Surface surface, Shading s, Parameters p) {
  vec3 N = s.N, V = s.V;
  vec3 radiance = directionalLights(s, p);
#if defined(POINT_LIGHTS) || defined(PLACED_LIGHTS)
  vec3 position = worldPosition(gl_FragCoord.xy, texelFetch(gDepth, pixel, 0).r);
  int texel = inLights.x;
#endif
#ifdef POINT_LIGHTS
  radiance += pointLights(s, p, position, texel, inLights.y);
  texel += inLights.y * kPointLightTexels;
#endif
#ifdef PLACED_LIGHTS
  // A loop for each kind: software GL runs through all that a loop holds.
#define LIGHTS_OF_KIND(kind, count) \
  for (int i = 0; i < (count); ++i, texel += kPlacedLightTexels) \
    radiance += placedLight(placedLightAt(texel, kind, position), s, p) * texelFetch(tileLights, texel + 1).rgb * lightVisibility(placedShadowAt(texel));
#ifdef SPOT_LIGHTS
  LIGHTS_OF_KIND(kSpotLight, inLights.z & 0xffff)
#endif
#ifdef COSINES
  Receiver receiving = receiver(s, p);
#undef LIGHTS_OF_KIND
  // One that is left over is taken twice.
#define LIGHTS_OF_KIND(kind, count) \
  for (int end = texel + (count) * kPlacedLightTexels; texel < end;) { \
    int other = min(texel + kPlacedLightTexels, end - kPlacedLightTexels); \
    Lit lit = areaLights(placedLightAt(texel, kind, position), placedLightAt(other, kind, position), receiving, s, p); \
    radiance += lit.one * texelFetch(tileLights, texel + 1).rgb * lightVisibility(placedShadowAt(texel)); \
    if (other > texel) radiance += lit.two * texelFetch(tileLights, other + 1).rgb * lightVisibility(placedShadowAt(other)); \
    texel = other + kPlacedLightTexels; \
  }
#endif
#ifdef SPHERE_LIGHTS
  LIGHTS_OF_KIND(kSphereLight, inLights.z >> 16)
#endif
#ifdef TUBE_LIGHTS
  LIGHTS_OF_KIND(kTubeLight, inLights.w & 0xffff)
#endif
#ifdef RECTANGLE_LIGHTS
  LIGHTS_OF_KIND(kRectangleLight, inLights.w >> 16)
#endif
#endif
#ifdef ENVIRONMENT
  // Split sum (Karis 2013, eq. 7 and 8) with the model's own lobe and tables.
  s.analyticLight = false;
  float NoV = clamp(dot(N, V), 0.0, 1.0), level = modelReadsRoughness ? levelOf(surface.roughness) : kOwnLobeLevel;
  EnvironmentBrdf brdf = environmentBrdfAt(NoV, surface.roughness);
  vec3 R = 2.0 * dot(N, V) * N - V;
#ifdef MODEL_TANGENT
  vec3 specularLight = stretchedLight(s, level);
#else
  vec3 specularLight = textureLod(prefilteredEnvironment, environmentFromWorld(R), level).rgb;
#endif
  vec3 reflected = modelHasEnvironment ? modelEnvironment(s, p) : s.F0 * brdf.scale + brdf.bias;
  vec3 diffuseLight = diffuseIrradiance(environmentFromWorld(N));
#ifdef MODEL_IS_WHOLE
  vec3 diffuseColor = vec3(1.0);  // its own is in the table
#else
  vec3 diffuseColor = s.diffuseColor;
#endif
#ifdef NO_MATERIAL_OCCLUSION
  float open = 1.0;
#else
  float open = surface.ambientOcclusion;
#endif
#ifdef SCREEN_OCCLUSION
  open *= surroundingsVisibility();
  specularLight *= specularOpenness(NoV, open, surface.roughness);
  diffuseLight *= open;
#endif
  vec3 light = specularLight * max(reflected, 0.0) + diffuseLight * diffuseColor * brdf.diffuse;
#ifdef MODEL_COAT
  setLight(s, R);
  float coatRoughness = clamp(modelCoatRoughness(p), 0.0, 1.0);
  EnvironmentBrdf coat = coloredBrdfAt(coatBrdf, NoV, coatRoughness);
  vec3 coatLight = textureLod(prefilteredCoat, environmentFromWorld(R), levelOf(coatRoughness)).rgb;
#ifdef SCREEN_OCCLUSION
  coatLight *= specularOpenness(NoV, open, coatRoughness);
#endif
  light = light * modelThroughCoat(s, p) + coatLight * max(s.F0 * coat.scale + coat.bias, 0.0) * modelCoatStrength(p);
#endif
#ifdef COMPENSATE
  // What a single bounce loses comes back from all sides.
  Shading white = s;
  white.F0 = vec3(1.0);
  vec3 single = modelHasEnvironment ? max(modelEnvironment(white, p), 0.0) : vec3(brdf.white);
#ifdef MODEL_COAT
  single = single * modelThroughCoat(white, p) + max(coat.scale + coat.bias, 0.0) * modelCoatStrength(p);
#endif
  light += diffuseLight * glintBounceTint(s, glintBouncesTowards(s)) * max(1.0 - max(single.r, max(single.g, single.b)), 0.0);
#endif
  if (modelScatters) {
    // From all sides, by the corners of an icosahedron, in light as soft as what comes out of the surface.
    const vec2 k = vec2(0.5257311, 0.8506508);
#ifdef SCREEN_OCCLUSION
    float scattered = open;
#else
    float scattered = 1.0;
#endif
    for (int i = 0; i < 12; ++i) {
      vec3 corner = vec3(0.0, (i & 1) == 0 ? k.x : -k.x, (i & 2) == 0 ? k.y : -k.y);
      vec3 L = i < 4 ? corner : i < 8 ? corner.zxy : corner.yzx;
      setLight(s, L);
      light += modelScattered(s, p) * diffuseIrradiance(environmentFromWorld(L)) * (scattered * kPi / 3.0);
    }
  }
#ifdef SCREEN_OCCLUSION
  radiance += light * view.environmentIntensity;
#else
  radiance += light * (open * view.environmentIntensity);
#endif
#endif
  return radiance;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Surface surface;
  Shading s;
  Parameters p;
  shadePixel(pixel, surface, s, p);
#ifdef GROUND
  // GROUND 1: the background, as much darker as light is kept away; 2: itself. The rim, where the cavity ends, is the background.
  vec3 sent = sentOn(pixel, surface, s, p), behind = backgroundRadiance(gl_FragCoord.xy);
#if GROUND == 1
  withShadows = 0.0;
  vec3 whole = sentOn(pixel, surface, s, p);
  sent = behind * clamp((sent + 1e-6) / (whole + 1e-6), 0.0, 1.0);
#endif
  outColor = outputColor(mix(behind, sent, surface.cavity));
#else
  vec3 radiance = sentOn(pixel, surface, s, p) * surface.cavity;
#ifdef EMISSIVE
  radiance += texelFetch(gEmissive, pixel, 0).rgb;
#endif
#if defined(FURNACE) && !defined(SCENE_REFERRED)
  // A display ends at 1: what is over it would vanish too.
  float most = max(radiance.r, max(radiance.g, radiance.b));
  radiance = min(radiance, 1.0) * mix(vec3(1.0, 0.22, 0.04), vec3(1.0), 1.0 / max(most, 1.0));
#endif
  outColor = outputColor(radiance);
#endif
}
