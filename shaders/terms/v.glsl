// Visibility, V = G / (4 NoL NoV), where G is the shadowing and masking of microfacets. A head names one as
// "V": "SmithGGX", or as "G": "SmithGGX", which is the same thing: G is V times 4 NoL NoV. Writing V itself
// keeps the division out, which is 0/0 at grazing angles although V is finite there.
#ifndef GLINT_TERMS_V
#define GLINT_TERMS_V

// Hoffman 2013, "Background: Physics and Math of Shading": G = NoL NoV.
float V_Implicit(Shading s) { return 0.25; }

// Neumann et al. 1999: G = NoL NoV / max(NoL, NoV).
float V_Neumann(Shading s) { return 0.25 / max(s.NoL, s.NoV); }

// Kelemen and Szirmay-Kalos 2001: G = NoL NoV / (v.h)^2. The floor is for opposite directions, where v.h = 0.
float V_Kelemen(Shading s) { return 0.25 / max(s.VoH * s.VoH, 1e-8); }

// Cook and Torrance 1982, V-cavities: G = min(1, 2 NoH NoV / VoH, 2 NoH NoL / VoH).
float V_CookTorrance(Shading s) {
  float VoH = max(s.VoH, 1e-4);
  return min(VoH, 2.0 * s.NoH * min(s.NoL, s.NoV)) / (4.0 * s.NoL * s.NoV * VoH);
}

// Walter et al. 2007, eq. 27: a rational fit of Smith's G1 for Beckmann, here divided by 2 NoX. It is off by
// up to 0.35 %, and steps by 6e-5 where it is cut at c = 1.6.
float halfVisibilityBeckmann(float NoX, float alpha) {
  float t = inversesqrt(max(1.0 - NoX * NoX, 1e-8)) / alpha;
  float c = NoX * t;
  return c < 1.6 ? t * (1.7675 + 1.0905 * c) / (1.0 + c * (2.276 + 2.577 * c)) : 0.5 / NoX;
}

// Smith 1967 for Beckmann: Walter et al. 2007, with light and view independent.
float V_SmithBeckmann(Shading s) {
  return halfVisibilityBeckmann(s.NoL, s.alpha) * halfVisibilityBeckmann(s.NoV, s.alpha);
}

// Schlick 1994, eq. 19: G1(x) = NoX / (NoX (1 - k) + k). Models differ in k.
float visibilitySchlick(Shading s, float k) {
  return 0.25 / ((s.NoL * (1.0 - k) + k) * (s.NoV * (1.0 - k) + k));
}

// k = alpha sqrt(2 / pi), Schlick's own, which fits a wrong form of Smith's function (Hoffman 2013).
float V_SchlickBeckmann(Shading s) { return visibilitySchlick(s, s.alpha * 0.79788456); }

// k = alpha / 2, fitted to GGX: Karis 2013, p. 3. Exact at alpha = 1.
float V_SchlickGGX(Shading s) { return visibilitySchlick(s, 0.5 * s.alpha); }

// k = (roughness + 1)^2 / 8: Karis 2013, eq. 4, Burley's remapping against "hotness". For lights only: under an
// environment it is far too dark at grazing angles.
float V_SchlickGGXHot(Shading s) {
  float r = s.roughness + 1.0;
  return visibilitySchlick(s, r * r * 0.125);
}

// Smith 1967 for GGX: Walter et al. 2007, eq. 34, with light and view independent.
float V_SmithGGX(Shading s) {
  return 1.0 / ((s.NoL + sqrt(s.NoL * s.NoL * (1.0 - s.alpha2) + s.alpha2)) *
                (s.NoV + sqrt(s.NoV * s.NoV * (1.0 - s.alpha2) + s.alpha2)));
}

// Heitz 2014, eq. 99: the same with heights correlated.
float V_SmithGGXCorrelated(Shading s) {
  return 0.5 / (s.NoL * sqrt(s.NoV * s.NoV * (1.0 - s.alpha2) + s.alpha2) +
                s.NoV * sqrt(s.NoL * s.NoL * (1.0 - s.alpha2) + s.alpha2));
}

// Unreal's approximation of it without roots: sqrt(x^2 (1 - alpha^2) + alpha^2) becomes x (1 - alpha) + alpha,
// so V = 0.5 / (NoL (NoV (1 - a) + a) + NoV (NoL (1 - a) + a)). (Herman's thesis, sec. 4.1.2, prints it without
// the reciprocal and one term twice.) Darker than Heitz by up to 29 %; exact at alpha = 1.
float V_SmithGGXCorrelatedApprox(Shading s) {
  return 0.5 / mix(2.0 * s.NoL * s.NoV, s.NoL + s.NoV, s.alpha);
}

#endif
