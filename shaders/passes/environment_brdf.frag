#version 450 core
// The environment BRDF of a model (Karis 2013, eq. 8), over x: NoV, y: roughness. Any Fresnel is taken as linear in
// F0 through its values at 0.04 and 1, which is exact for Schlick's. Half-vector space with tan(theta_h) = alpha
// tan(psi): the same density of points for any width of the lobe. Alpha is 0 where a value is not finite.
#include "shaders/common/shading.glsl"
#pragma glint model
#include "shaders/common/floor_light.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outScale;    // on F0
layout(location = 1) out vec4 outBias;     // w: the largest albedo of facets that reflect all
layout(location = 2) out vec4 outDiffuse;  // albedo of the diffuse part for diffuseColor 1
uniform vec2 size;
uniform vec4 standardParameters;
uniform bool plainNonmetal;
#ifdef MODEL_TANGENT
// The average over the view's azimuth: the tangent turns instead, and half a turn of half vectors sees it all.
const int kFrames = 4, kPhi = 24;
#else
const int kFrames = 1, kPhi = 48;
#endif
const int kPsi = 64, kDiffuse = 16;

void main() {
  // The first and last texels stand on 0 and 1, so that the ends of the table are exact.
  vec2 ends = (gl_FragCoord.xy - 0.5) / (size - 1.0);
#ifdef MODEL_IS_WHOLE
  // On the normal the azimuth of the view, which some divide by, has no value.
  float NoV = clamp(ends.x, 1e-3, 0.99995);
#else
  float NoV = max(ends.x, 1e-3);
#endif
  vec3 N = vec3(0.0, 0.0, 1.0);
  vec3 V = vec3(sqrt(max(1.0 - NoV * NoV, 0.0)), 0.0, NoV);
  Shading s;
  setRoughness(s, ends.y);
  setView(s, N, V);
  s.diffuseColor = s.baseColor = vec3(1.0);
  s.metallic = 1.0;
  s.specular = 0.5;
  s.analyticLight = false;
  s.plainNonmetal = plainNonmetal;
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  if (kFrames > 1) turnTangent(s, 0.5 * kPi / float(kFrames));
  Parameters p = modelParameters(standardParameters);

  vec3 at004 = vec3(0.0), at1 = vec3(0.0), white = vec3(0.0);
  for (int n = 0; n < kFrames * kPsi; ++n) {
    int i = n % kPsi;
    if (i == 0) {
      if (n > 0) turnTangent(s, kPi / float(kFrames));
      modelPrepare(s, p);
    }
    float u = (float(i) + 0.5) / float(kPsi), psi = u * 1.5707963267948966;
    float t = s.alpha * tan(psi);
    // A lobe of unknown width: as dense for each, theta_h = kSmallest (e^(k u) - 1).
    const float kSmallest = 1e-3;
    float k = log(1.0 + 1.5707963267948966 / kSmallest), grown = kSmallest * exp(k * u);
    if (!modelReadsRoughness) t = tan(grown - kSmallest);
    float cos2 = 1.0 / (1.0 + t * t);
    float cosTheta = sqrt(cos2), sinTheta = t * cosTheta;
    // d omega_h = sin(theta) d theta d phi; d theta = alpha cos^2(theta) / cos^2(psi) d psi; both halves of phi.
    float cosPsi = cos(psi);
    float measure = sinTheta * s.alpha * cos2 / (cosPsi * cosPsi) * (1.5707963267948966 / float(kPsi)) *
                    (2.0 * kPi / float(kPhi * kFrames));
    if (!modelReadsRoughness) measure = sinTheta * grown * k / float(kPsi) * (2.0 * kPi / float(kPhi * kFrames));
    for (int j = 0; j < kPhi; ++j) {
      float phi = (float(j) + 0.5) / float(kPhi) * kPi;
      vec3 H = vec3(sinTheta * cos(phi), sinTheta * sin(phi), cosTheta);
      float VoH = dot(V, H);
      vec3 L = 2.0 * VoH * H - V;
      if (VoH > 0.0 && L.z > 0.0) {
        setLight(s, L);
        // From the half vector itself: going through L loses its last digits.
        s.sinH2 = sinTheta * sinTheta;
        s.NoH = cosTheta;
        float weight = measure * 4.0 * VoH * L.z;
#ifdef MODEL_IS_WHOLE
        at004 += finiteLight(modelSpecular(s, p)) * weight;
        at1 = at004;  // it reads no F0
#else
        s.F0 = vec3(0.04);
        at004 += modelLobe(s, p) * weight;
        s.F0 = vec3(1.0);
        at1 += modelLobe(s, p) * weight;
        white += modelLobeWhite(s, p) * weight;
#endif
      }
    }
  }
  s.F0 = vec3(0.04);
  s.metallic = 0.0;
  vec3 diffuseAlbedo = vec3(0.0);
  for (int i = 0; i < kDiffuse; ++i)
    for (int j = 0; j < kDiffuse; ++j) {
      // Cosine-weighted, stratified: f / pdf is pi f.
      float cos2 = (float(i) + 0.5) / float(kDiffuse);
      float phi = (float(j) + 0.5) / float(kDiffuse) * kPi;
      vec3 L = vec3(sqrt(1.0 - cos2) * cos(phi), sqrt(1.0 - cos2) * sin(phi), sqrt(cos2));
      setLight(s, L);
      diffuseAlbedo += modelDiffuseBelow(s, p) * kPi / float(kDiffuse * kDiffuse);
    }
  vec3 scale = (at1 - at004) / 0.96, bias = at004 - 0.04 * scale;
#ifdef MODEL_IS_WHOLE
  diffuseAlbedo = min(kPi * modelFloor(s, p), bias);
  bias -= diffuseAlbedo;
#endif
  // One sum: compilers make a maximum of several comparisons, and a maximum forgets NaN.
  bool sound = dot(abs(scale) + abs(bias) + abs(white) + abs(diffuseAlbedo), vec3(1.0)) < 1e4;
  outScale = sound ? vec4(scale, 1.0) : vec4(0.0);
  outBias = sound ? vec4(bias, max(white.r, max(white.g, white.b))) : vec4(0.0, 0.0, 0.0, 1.0);
  outDiffuse = sound ? vec4(diffuseAlbedo, 1.0) : vec4(0.0);
}
