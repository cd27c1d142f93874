#version 450 core
// The reference at single points, and what the fast path makes of the same light (renderer/reference_probe.h). Each pixel
// is the mean of its own run of samples, or one approximation.
#include "shaders/common/gbuffer.glsl"
#include "shaders/common/shading.glsl"
#pragma glint model
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
#include "shaders/common/lights.glsl"

// The world is the environment's own frame.
vec3 environmentFromWorld(vec3 d) { return d; }
vec3 worldFromEnvironment(vec3 d) { return d; }
#ifdef IRRADIANCE
vec3 referenceOne(Shading s, Parameters p) { return vec3(1.0); }
#define REFERENCE_LIT referenceOne
#else
#define REFERENCE_LIT modelSpecular
#endif
#include "shaders/common/reference.glsl"
#if defined(ENVIRONMENT) || defined(FURNACE)
#include "shaders/common/reference_environment.glsl"
#endif

uniform vec4 standardParameters;
uniform bool plainNonmetal;
uniform int lightKind;
uniform vec4 placed[4];    // PlacedBlock of renderer/prepared_view.h, from the point
uniform vec3 normal, viewer, reflectance;
uniform float roughness;
uniform int sampleCount, pixelsAcross;

#ifdef APPROXIMATIONS
// Eq. 18 (Karis 2013): the point of a segment at the smallest angle to the ray, from 0 at its start to 1.
float smallestAngle(vec3 start, vec3 along, vec3 ray) {
  float a = dot(start, along), b = dot(ray, start), c = dot(ray, along), denominator = a * c - dot(along, along) * b;
  return abs(denominator) > 1e-12 ? clamp((a * b - dot(start, start) * c) / denominator, 0.0, 1.0) : 0.5;
}

// ReferenceProbe::Approximation.
vec3 approximation(int which, PlacedLight light, Shading s, Parameters p) {
  float distance = length(light.center), size = light.extent.x;
  float wide = sphereNormalization(s.alpha, widenedAlpha(s.alpha, size, distance, 3.0));
  vec3 ray = 2.0 * dot(s.N, s.V) * s.N - s.V, along = 2.0 * light.along, start = light.center - light.along;
  PlacedLight drawn = light;
  if (which == 0) {
    drawn.kind = kSpotLight;
    drawn.extent = vec2(0.0, 1.0);
  }
  Arrival a = representativePoint(drawn, s, which == 1 ? 3 : which == 2 || which == 7 ? 4 : which == 4 ? 2 : 1);
  if (which == 5) a.specular = max(dot(s.N, a.specularL), 0.0) / (distance * distance) * wide;
  if (which == 6) a.specularL = normalize(2.0 * light.center - nearestOfSphere(light.center, size, ray));
  if (which == 7) a.specular *= wide * lineNormalization(s.alpha, widenedAlpha(s.alpha, length(light.along), distance, 3.0));
  if (which == 8) a.specularL = normalize(nearestOfSphere(start + smallestAngle(start, along, ray) * along, size, ray));
  setLight(s, a.specularL);
  if (dot(s.N, s.L) <= 0.0) return vec3(0.0);
  Shading widened = s;
  if (a.widened > 0.0) setRoughness(widened, sqrt(a.widened));
  return (a.widened > 0.0 ? modelD(widened, p) * modelV(s, p) * modelF(s, p) : modelSpecular(s, p)) * a.specular;
}
#endif

void main() {
  Shading s;
  setRoughness(s, roughness);
  setView(s, normal, viewer);
  setColors(s, vec3(1.0), 1.0, 0.5);
  s.F0 = reflectance;
  s.T = anyTangent(normal);
  s.B = cross(normal, s.T);
  s.plainNonmetal = plainNonmetal;
#if defined(ENVIRONMENT) || defined(FURNACE)
  s.analyticLight = false;
#else
  s.analyticLight = true;
#endif
  Parameters p = modelParameters(standardParameters);
  modelPrepare(s, p);
  PlacedLight light = PlacedLight(lightKind, placed[0].xyz, placed[0].w, placed[1].w, placed[2].xyz, placed[3].xyz, vec2(placed[2].w, placed[3].x));
  int index = int(gl_FragCoord.y) * pixelsAcross + int(gl_FragCoord.x);
#ifdef APPROXIMATIONS
  outColor = vec4(approximation(index, light, s, p), 1.0);
#else
  Proposal q = referenceProposal(s, p);
  uint first = uint(index) * uint(sampleCount);
#if defined(ENVIRONMENT) || defined(FURNACE)
  vec3 sum = referenceEnvironment(s, p, q, first, sampleCount, uvec3(0u));
#else
  vec3 sum = referenceLight(light, s, p, q, first, sampleCount, uvec3(0u)) * placed[1].rgb * attenuation(light);
#endif
  outColor = vec4(sum, referenceSound ? 1.0 : 0.0);
#endif
}
