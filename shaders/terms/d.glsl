// Distributions of microfacet normals, D(h) in 1/sr, normalised: the integral of D (n.h) over the hemisphere
// is 1. Each is a function of `Shading`; a head names it without its prefix ("D": "GGX").
//
// All use s.sinH2 = 1 - (n.h)^2, not n.h: near the highlight of a smooth surface 1 - (n.h)^2 computed from n.h
// has no correct digits left in single precision (Karis 2013, eq. 3 is off by 3 % at roughness 0.05).
#ifndef GLINT_TERMS_D
#define GLINT_TERMS_D

// (n.h)^2 with all its digits: far from the normal 1 - sinH2 has lost them.
float cosH2(Shading s) { return s.sinH2 > 0.5 ? s.NoH * s.NoH : 1.0 - s.sinH2; }

// Trowbridge and Reitz 1975; Walter et al. 2007, eq. 33; Karis 2013, eq. 3: alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2).
float D_GGX(Shading s) {
  float q = s.alpha / (s.sinH2 * (1.0 - s.alpha2) + s.alpha2);
  return q * q * (1.0 / kPi);
}

// Burley 2012, sec. 5.4: the widths along and across the tangent for anisotropy -1..1, which keep alpha^2 = ax ay;
// a negative one turns the lobe by 90 degrees.
vec2 anisotropicAlpha(float alpha, float anisotropy) {
  float aspect = sqrt(1.0 - 0.9 * min(abs(anisotropy), 1.0));
  vec2 along = vec2(alpha / aspect, alpha * aspect);
  return anisotropy < 0.0 ? along.yx : along;
}

// Burley 2012, eq. 13 (appendix B): 1 / (pi ax ay ((h.x / ax)^2 + (h.y / ay)^2 + (n.h)^2)^2), h in the tangent frame.
float anisotropicGGX(vec2 a, vec3 h) {
  vec3 scaled = h / vec3(a, 1.0);
  float q = 1.0 / dot(scaled, scaled);
  return q * q / (kPi * a.x * a.y);
}

// GGX that is wider along the tangent.
//   anisotropy from -1 to 1, 0.5: 0 is GGX, negative values stretch the highlight across the tangent
float D_GGXaniso(Shading s, float anisotropy) {
  return anisotropicGGX(anisotropicAlpha(s.alpha, anisotropy), vec3(dot(s.T, s.H), dot(s.B, s.H), s.NoH));
}

// Beckmann and Spizzichino 1963; Walter et al. 2007, eq. 25: exp(-tan^2 / alpha^2) / (pi alpha^2 (n.h)^4).
float D_Beckmann(Shading s) {
  // Below cos^2 = 1e-3 the exponential has reached zero for every alpha; the floor keeps 0 * infinity away.
  float cos2 = max(cosH2(s), 1e-3);
  float k = 1.0 / (s.alpha2 * cos2);
  return exp(-s.sinH2 * k) * k / (kPi * cos2);
}

// ln(x) from x in (0, 1] and 1 - x, to single precision also near 1, where log(x) alone would only see the
// digits of 1 - x that x has room for.
float preciseLog(float x, float oneMinusX) {
  float t = oneMinusX / (1.0 + x);  // ln(x) = -2 artanh(t)
  float t2 = t * t;
  float series = -2.0 * t * (1.0 + t2 * (1.0 / 3.0 + t2 * (1.0 / 5.0 + t2 * (1.0 / 7.0))));
  return x > 0.7 ? series : log(max(x, 1e-30));
}

// Blinn 1977, with the exponent 2 / alpha^2 - 2 of Walter et al. 2007, sec. 5.2, and Karis 2013 ("Specular BRDF
// reference"): (n.h)^(2 / alpha^2 - 2) / (pi alpha^2).
float D_Blinn(Shading s) {
  float k = 1.0 / s.alpha2;
  return exp((k - 1.0) * preciseLog(cosH2(s), s.sinH2)) * k * (1.0 / kPi);
}

// Generalised Trowbridge-Reitz, Burley 2012, eq. 4 (appendix B), for gamma > 0:
//   (gamma - 1)(alpha^2 - 1) / (pi (1 - alpha^(2 (1 - gamma))) (1 + (alpha^2 - 1)(n.h)^2)^gamma)
// gamma 2 is GGX; a smaller one has a longer tail. The normalisation is 0/0 at gamma = 1 and at alpha = 1, and for large
// gamma and small alpha both it and the power leave single precision. Here it is the value at the normal, D(n), times
// a power of a number from 0 to 1; D(n) is made of factors that go smoothly to 1, with x = (gamma - 1) ln(alpha^2):
//   D(n) = 1 / (pi alpha^2)  times  x / (e^x - 1)  times  (1 - alpha^2) / -ln(alpha^2)
float peakGTR(float alpha2, float gamma) {
  float y = 1.0 - alpha2;
  float logAlpha2 = preciseLog(alpha2, y);
  float x = (gamma - 1.0) * logAlpha2;
  // (e^x - 1) / x, whose difference cancels for small x.
  float series = 1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0)))));
  float growth = abs(x) < 0.5 ? series : (exp(x) - 1.0) / x;
  float shape = y < 1e-4 ? 1.0 - 0.5 * y : -y / logAlpha2;
  return shape / (kPi * growth * alpha2);
}

// With that value at hand: it is the same for every light, and costs more than all the rest.
float D_GTR(Shading s, float gamma, float peak) {
  return peak * pow(s.alpha2 / (s.sinH2 * (1.0 - s.alpha2) + s.alpha2), gamma);
}

// Generalised Trowbridge-Reitz, Burley 2012, eq. 4 (appendix B), with that value made on the spot.
//   gamma from 0.5 to 6, 1.5: how long the tail is: 1 the longest that is usual, 2 GGX, larger ones cut it short
float D_GTR(Shading s, float gamma) { return D_GTR(s, gamma, peakGTR(s.alpha2, gamma)); }

// Burley 2012, sec. 5.4: the clear coat's distribution, gamma = 1.
float D_GTR1(Shading s) { return D_GTR(s, 1.0); }

// Burley 2012, sec. 5.4: how wide it is for a gloss from 0 to 1.
float clearCoatAlpha(float gloss) { return mix(0.1, 0.001, gloss); }

// Gamma 1.5: half way between Berry and GGX, as the thesis (Herman, sec. 4.4.1) takes it.
float D_GTR1_5(Shading s) { return D_GTR(s, 1.5); }

// Gamma 3: a shorter tail than GGX has.
float D_GTR3(Shading s) { return D_GTR(s, 3.0); }

// Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF", eq. 2: fibres that stand upright,
// (2 + 1/alpha) sin^(1/alpha)(theta) / (2 pi).
float D_Charlie(Shading s) {
  float k = 1.0 / s.alpha;
  return (2.0 + k) * exp(0.5 * k * preciseLog(s.sinH2, cosH2(s))) * (0.5 / kPi);
}

#endif
