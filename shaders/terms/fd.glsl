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

#endif
