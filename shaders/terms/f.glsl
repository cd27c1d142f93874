// Fresnel reflectance of the microfacets, F(v.h), from F0 = s.F0.
#ifndef GLINT_TERMS_F
#define GLINT_TERMS_F

// (1 - x)^5: Schlick's weight.
float schlickWeight(float x) {
  float m = 1.0 - x;
  float m2 = m * m;
  return m2 * m2 * m;
}

// F0 at w = 0, white at w = 1.
vec3 fresnelToWhite(vec3 F0, float w) { return F0 * (1.0 - w) + w; }

// The same at every angle.
vec3 F_None(Shading s) { return s.F0; }

// Schlick 1994, eq. 15.
vec3 F_Schlick(Shading s) { return fresnelToWhite(s.F0, schlickWeight(s.VoH)); }

// Karis 2013, eq. 5: Schlick's power as a spherical Gaussian (Lagarde 2012); differs from it by at most 0.0038.
vec3 F_SphericalGaussian(Shading s) {
  return fresnelToWhite(s.F0, exp2((-5.55473 * s.VoH - 6.98316) * s.VoH));
}

// Cook and Torrance 1982: the dielectric's equation for the index eta = (1 + sqrt F0) / (1 - sqrt F0),
//   F = ((g - c) / (g + c))^2 / 2 (1 + (((g + c) c - 1) / ((g - c) c + 1))^2),  g^2 = eta^2 - 1 + c^2.
// Here g and c carry a factor u = 1 - sqrt F0, so that F0 = 1 gives 1 where eta is infinite, and g - c is
// 4 sqrt F0 / (g + c), so that it does not cancel for small F0. For dielectrics: at high F0 it dips.
vec3 F_CookTorrance(Shading s) {
  float c = s.VoH;
  vec3 q = sqrt(clamp(s.F0, 0.0, 1.0));
  vec3 u = max(1.0 - q, 1e-12);
  vec3 sum = sqrt(4.0 * q + u * u * c * c) + u * c;
  vec3 difference = 4.0 * q / max(sum, 1e-12);
  vec3 a = difference / max(sum, 1e-12);
  vec3 b = (sum * c - u) / (difference * c + u);
  return 0.5 * a * a * (1.0 + b * b);
}

#endif
