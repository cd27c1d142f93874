// Specular antialiasing: a lobe as wide as the normals within a pixel vary, so that its highlight neither glitters nor
// comes and goes as the surface moves by parts of a pixel. After shading.glsl.

// How much wider alpha^2 must be for a smooth surface that bends within the pixel: from the normal's change to the next
// pixels (Tokuyoshi and Kaplanyan 2019, "Improved Geometric Specular Antialiasing", section 4.2, the filter for deferred
// shading, with its constants: a pixel as a Gaussian of variance 1 / 2 pi, and a bound for rims, where derivatives are
// noise). Their filter has twice the sum of the variances along x and y, which is no less than is needed whatever the
// bend, and under an environment is farther from a supersampled picture than no filter. This has the sum, twice the mean of
// the two, which is what a round lobe has. Towards rims a pixel covers 1 / NoV more of the bend, but along one axis only:
// there a round lobe has the geometric mean; `ray`, towards the surface, is near enough to a unit vector. `share` is the part of the pixel that is drawn: 1 / the pictures averaged.
float alpha2OfBend(vec3 normal, vec3 ray, float share) {
  const float kPixelVariance = 0.15915494, kMost = 0.18;
  vec3 dx = dFdx(normal), dy = dFdy(normal);
  return min(kPixelVariance * share * (dot(dx, dx) + dot(dy, dy)), kMost) * clamp(-dot(normal, ray), 0.0, 1.0);
}

// Of a normal map, from the variance of its slopes along one axis: alpha^2 is twice that (Beckmann's own width; Toksvig 2005).
float alpha2OfSlopes(float variance) { return 2.0 * max(variance, 0.0); }

// The roughness whose alpha^2 is greater by so much: the inverse of alphaFromRoughness(), which is where 1 is the widest.
float widenedRoughness(float roughness, float alpha2) {
  float alpha = alphaFromRoughness(clamp(roughness, 0.0, 1.0));
  return sqrt(sqrt(min(alpha * alpha + alpha2, 1.0)));
}
