// From scene-referred radiance, with its exposure, to what a display shows. TONEMAP is one of the names below.
#define TONEMAP_NONE 0
#define TONEMAP_ACES 1
#define TONEMAP_AGX 2
#define TONEMAP_PBR_NEUTRAL 3
#ifndef TONEMAP
#define TONEMAP TONEMAP_NONE
#endif

#if TONEMAP == TONEMAP_ACES
// Hill 2016, the fit of ACES' reference and output transforms with its sRGB matrices.
vec3 tonemap(vec3 c) {
  c = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777) * c;
  c = (c * (c + 0.0245786) - 0.000090537) / (c * (0.983729 * c + 0.4329510) + 0.238081);
  return mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602) * c;
}
#elif TONEMAP == TONEMAP_AGX
// AgX (Sobotka 2022) as fitted by Wrensch 2023: log encoding, sigmoid of degree six, sRGB primaries in and out.
vec3 tonemap(vec3 c) {
  c = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992, 0.878468636469772,
           0.0784336, 0.0792237451477643, 0.0791661274605434, 0.879142973793104) * c;
  c = clamp((log2(max(c, 1e-10)) + 12.47393) / (4.026069 + 12.47393), 0.0, 1.0);
  vec3 c2 = c * c, c4 = c2 * c2;
  c = 15.5 * c4 * c2 - 40.14 * c4 * c + 31.96 * c4 - 6.868 * c2 * c + 0.4298 * c2 + 0.1191 * c - 0.00232;
  c = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438, -0.0980208811401368, 1.15190312990417,
           -0.0980434501171241, -0.0990297440797205, -0.0989611768448433, 1.15107367264116) * c;
  // The sigmoid yields display-encoded values; the target encodes again, so go back to linear.
  return pow(max(c, 0.0), vec3(2.2));
}
#elif TONEMAP == TONEMAP_PBR_NEUTRAL
// Khronos PBR Neutral tone mapper, specification 1.0 (2024).
vec3 tonemap(vec3 c) {
  const float startCompression = 0.8 - 0.04, desaturation = 0.15;
  float x = min(c.r, min(c.g, c.b));
  c -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  float peak = max(c.r, max(c.g, c.b));
  float d = 1.0 - startCompression;
  float newPeak = 1.0 - d * d / (peak + d - startCompression);
  vec3 compressed = c * (newPeak / max(peak, 1e-6));
  float g = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return peak < startCompression ? c : mix(compressed, vec3(newPeak), g);
}
#else
vec3 tonemap(vec3 c) { return c; }
#endif

vec3 displayed(vec3 c) { return clamp(tonemap(max(c, 0.0)), 0.0, 1.0); }
