#version 450 core
// What a model sends on from half vectors spread over its lobe under lights, for renderer/area_light_tables.cpp: x is the
// half vector, y the view (NoV, then roughness). Written: f NoL d omega, for F0 of 1 and 0.04; w of the first is that of
// facets that reflect all.
#include "shaders/common/shading.glsl"
#pragma glint model
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outAt1;
layout(location = 1) out vec4 outAt004;
uniform vec4 standardParameters;
uniform bool plainNonmetal;
uniform ivec2 halfVectors;   // rings around the normal, and in half a turn
uniform ivec2 views;         // of NoV, and of roughness

// As sampleOf() of renderer/area_light_tables.cpp.
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float x = float(at.y % views.x) / float(views.x - 1), roughness = float(at.y / views.x) / float(views.y - 1);
  float NoV = max(1.0 - x * x, 1e-3);
  vec3 N = vec3(0.0, 0.0, 1.0), V = vec3(sqrt(max(1.0 - NoV * NoV, 0.0)), 0.0, NoV);
  Shading s;
  setRoughness(s, roughness);
  setView(s, N, V);
  s.diffuseColor = s.baseColor = s.F0 = vec3(1.0);
  s.metallic = 1.0;
  s.specular = 0.5;
  s.analyticLight = true;
  s.plainNonmetal = plainNonmetal;
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  Parameters p = modelParameters(standardParameters);
  modelPrepare(s, p);
  float step = 0.5 * kPi / float(halfVectors.x), psi = (float(at.x % halfVectors.x) + 0.5) * step;
  float phi = (float(at.x / halfVectors.x) + 0.5) / float(halfVectors.y) * kPi;
  float width = modelReadsRoughness ? s.alpha : 0.2, t = width * tan(psi), cos2 = 1.0 / (1.0 + t * t);
  float cosTheta = sqrt(cos2), sinTheta = t * cosTheta, cosPsi = cos(psi);
  float measure = sinTheta * width * cos2 / (cosPsi * cosPsi) * step * (2.0 * kPi / float(halfVectors.y));
  vec3 H = vec3(sinTheta * cos(phi), sinTheta * sin(phi), cosTheta);
  float VoH = dot(V, H);
  vec3 L = 2.0 * VoH * H - V;
  outAt1 = outAt004 = vec4(0.0);
  if (VoH <= 0.0 || L.z <= 0.0) return;
  setLight(s, L);
  s.sinH2 = sinTheta * sinTheta;
  s.NoH = cosTheta;
  float weight = L.z * 4.0 * VoH * measure;
  vec3 white = modelLobeWhite(s, p);
  outAt1 = vec4(modelLobe(s, p), max(white.r, max(white.g, white.b))) * weight;
  s.F0 = vec3(0.04);
  outAt004 = vec4(modelLobe(s, p) * weight, 0.0);
}
