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

// Heitz 2014, eq. 86 and 99, for GGX that is wider along the tangent: a = the widths, l and v in the tangent frame.
float anisotropicVisibility(vec2 a, vec3 l, vec3 v) {
  return 0.5 / (l.z * length(vec3(a * v.xy, v.z)) + v.z * length(vec3(a * l.xy, l.z)));
}

// GGX's height-correlated visibility for D_GGXaniso.
//   anisotropy from -1 to 1, 0.5: 0 is GGX, negative values stretch the highlight across the tangent
float V_SmithGGXCorrelatedAniso(Shading s, float anisotropy) {
  return anisotropicVisibility(anisotropicAlpha(s.alpha, anisotropy), vec3(dot(s.T, s.L), dot(s.B, s.L), s.NoL),
                               vec3(dot(s.T, s.V), dot(s.B, s.V), s.NoV));
}

// What the facets of the model's own D show towards light and view, for each unit of the surface: the integral of
// D(h) max(v.h, 0) over all h (Heitz 2014, eq. 14). Glint makes it from D: renderer/model_tables.h.
struct ProjectedAreas { float light, view; };

// Smith 1967 for whatever D the model has, light and view independent: G1(v) = NoV / area(v), V = G1 G1 / (4 NoL NoV).
float V_Smith(Shading s, ProjectedAreas area) { return 0.25 / (area.light * area.view); }

// The same with heights correlated: G = 1 / (1 + Lambda(l) + Lambda(v)), 1 + Lambda = area / cosine (Heitz 2014, eq. 99).
float V_SmithCorrelated(Shading s, ProjectedAreas area) {
  return 0.25 / (area.light * s.NoV + area.view * s.NoL - s.NoL * s.NoV);
}

// Neubelt and Pettineo 2013, "Crafting a Next-Gen Material Pipeline": for cloth, smooth where light and view graze.
float V_Neubelt(Shading s) { return 0.25 / (s.NoL + s.NoV - s.NoL * s.NoV); }

// Estevez and Kulla 2017, eq. 3: Smith's Lambda for D_Charlie, fitted; mirrored at cos = 1/2.
float lambdaCharlie(float cosine, float alpha) {
  float k = (1.0 - alpha) * (1.0 - alpha);
  float a = mix(21.5473, 25.3245, k), b = mix(3.82987, 3.32435, k), c = mix(0.19823, 0.16801, k);
  float d = mix(-1.97760, -1.27393, k), e = mix(-4.32054, -4.85967, k);
  float x = min(cosine, 1.0 - cosine);
  float fit = a / (1.0 + b * pow(max(x, 1e-7), c)) + d * x + e;
  float middle = a / (1.0 + b * pow(0.5, c)) + d * 0.5 + e;
  return exp(cosine < 0.5 ? fit : 2.0 * middle - fit);
}

// Estevez and Kulla 2017: Smith's function for D_Charlie, heights correlated.
float V_CharlieFit(Shading s) {
  return 0.25 / ((1.0 + lambdaCharlie(s.NoL, s.alpha) + lambdaCharlie(s.NoV, s.alpha)) * (s.NoL * s.NoV));
}

#endif
