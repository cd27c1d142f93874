#version 450 core
// What a model sends on from each cell of half vectors, for renderer/model_sampler.cpp, whose numbers these are.
#include "shaders/common/shading.glsl"
#pragma glint model
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Views { vec2 views[]; };       // roughness, NoV
layout(std430, binding = 1) writeonly buffer Cells { vec2 cells[]; };      // the light sent on for F0 0 and 1
uniform vec4 standardParameters;
const int kPolar = 32, kAround = 24, kInside = 2;
const float kSmallest = 2e-4;

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= views.length() * kPolar * kAround) return;
  vec2 view = views[index / (kPolar * kAround)];
  int cell = index % (kPolar * kAround), column = cell / kPolar, row = cell % kPolar;
  vec3 V = vec3(sqrt(max((1.0 - view.y) * (1.0 + view.y), 0.0)), 0.0, view.y);
  Shading s;
  setRoughness(s, view.x);
  setView(s, vec3(0.0, 0.0, 1.0), V);
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  s.baseColor = s.F0 = vec3(1.0);
  s.diffuseColor = vec3(0.0);
  s.specular = 0.5;
  s.metallic = 1.0;
  s.analyticLight = true;
  s.plainNonmetal = false;
  Parameters p = modelParameters(standardParameters);
  modelTurn(s, p);
  modelPrepare(s, p);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < kInside * kInside; ++i) {
    float u = (float(row) + (float(i % kInside) + 0.5) / float(kInside)) / float(kPolar);
    float phi = (float(column) + (float(i / kInside) + 0.5) / float(kInside)) * (2.0 * kPi / float(kAround));
    // As model_integrals.comp: the half vectors whose light is above the horizon, all of them and no others.
    float end = 0.25 * kPi + 0.5 * atan(V.x * cos(phi), V.z);
    float k = log(1.0 + end / kSmallest), grown = kSmallest * exp(k * u), theta = grown - kSmallest;
    float sinTheta = sin(theta);
    vec3 H = vec3(sinTheta * cos(phi), sinTheta * sin(phi), cos(theta));
    float VoH = dot(V, H);
    vec3 L = 2.0 * VoH * H - V;
    if (VoH <= 0.0 || L.z <= 0.0) continue;
    setLight(s, L);
    s.H = H;
    s.NoH = H.z;
    s.sinH2 = sinTheta * sinTheta;
    float weight = sinTheta * grown * k * 4.0 * VoH * L.z;
    s.F0 = vec3(0.0);
    vec3 black = modelSpecular(s, p);
    s.F0 = vec3(1.0);
    vec3 white = modelSpecular(s, p);
    // Sums: a maximum may forget NaN.
    sum += vec2(black.r + black.g + black.b, white.r + white.g + white.b) * (weight / 3.0);
  }
  cells[index] = sum * (2.0 * kPi / float(kPolar * kAround * kInside * kInside));
}
