// Diffuse parts, f itself with its 1/pi, from s.diffuseColor.
#ifndef GLINT_TERMS_FD
#define GLINT_TERMS_FD

// Lambert 1760.
vec3 Fd_Lambert(Shading s) { return s.diffuseColor * (1.0 / kPi); }

// Burley 2012, eq. 4: darker at grazing angles for smooth surfaces, brighter for rough ones.
vec3 Fd_Burley(Shading s) {
  float grazing = 2.0 * s.roughness * s.VoH * s.VoH - 0.5;  // F_D90 - 1
  return s.diffuseColor * ((1.0 + grazing * schlickWeight(s.NoL)) * (1.0 + grazing * schlickWeight(s.NoV)) / kPi);
}

// Oren and Nayar 1994, the qualitative model (its eq. 30), with sigma = roughness in radians.
vec3 Fd_OrenNayar(Shading s) {
  float sigma2 = s.roughness * s.roughness;
  float a = 1.0 - 0.5 * sigma2 / (sigma2 + 0.33);
  float b = 0.45 * sigma2 / (sigma2 + 0.09);
  // sin(larger angle) tan(smaller angle) cos(azimuth) = (LoV - NoL NoV) / max(NoL, NoV).
  float across = max(s.LoV - s.NoL * s.NoV, 0.0) / max(s.NoL, s.NoV);
  return s.diffuseColor * ((a + b * across) / kPi);
}

// Fujii 2011, "A tiny improvement of Oren-Nayar reflectance model", as Portsmouth, Kutz and Hill 2025 take it, "EON: A
// practical energy-preserving rough diffuse BRDF", eq. 15: f / albedo for a roughness from 0 to 1.
const float kFujii1 = 0.5 - 2.0 / (3.0 * kPi), kFujii2 = 2.0 / 3.0 - 28.0 / (15.0 * kPi);
float fujiiOrenNayar(float roughness, float NoL, float NoV, float LoV) {
  float s = LoV - NoL * NoV;
  float across = s > 0.0 ? s / max(NoL, NoV) : s;
  return (1.0 + roughness * across) / (kPi * (1.0 + kFujii1 * roughness));
}

// Its directional albedo for white, eq. 22 (exact). (1 - sin^3) / cos is written without its cancellation.
float fujiiAlbedo(float roughness, float cosine) {
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float g = sine * (acos(cosine) - sine * cosine) +
            2.0 / 3.0 * (sine * cosine * (1.0 + sine + sine * sine) / (1.0 + sine) - sine);
  return (1.0 + roughness * g / kPi) / (1.0 + kFujii1 * roughness);
}

// Single scattering only: darker the rougher.
vec3 Fd_FON(Shading s) { return s.diffuseColor * fujiiOrenNayar(s.roughness, s.NoL, s.NoV, s.LoV); }

// Portsmouth, Kutz and Hill 2025, eq. 28: with the light that is scattered more than once, which keeps all energy
// and saturates the colour.
vec3 Fd_EON(Shading s) {
  float average = (1.0 + kFujii2 * s.roughness) / (1.0 + kFujii1 * s.roughness);
  float lostL = max(1.0 - fujiiAlbedo(s.roughness, s.NoL), 1e-7);
  float lostV = max(1.0 - fujiiAlbedo(s.roughness, s.NoV), 1e-7);
  float lost = max(1.0 - average, 1e-7);
  vec3 color = s.diffuseColor * s.diffuseColor * (average / (1.0 - s.diffuseColor * lost));
  return Fd_FON(s) + color * (lostL * lostV / (lost * kPi));
}

#endif
