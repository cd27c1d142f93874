// Values at the points of a lattice, with a quintic between (Perlin 2002). 0 to 1.
float valueNoise(vec3 p) {
  vec3 cell = floor(p), f = p - cell;
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float a = hash33(cell).x, b = hash33(cell + vec3(1, 0, 0)).x;
  float c = hash33(cell + vec3(0, 1, 0)).x, d = hash33(cell + vec3(1, 1, 0)).x;
  float e = hash33(cell + vec3(0, 0, 1)).x, g = hash33(cell + vec3(1, 0, 1)).x;
  float h = hash33(cell + vec3(0, 1, 1)).x, k = hash33(cell + vec3(1, 1, 1)).x;
  return mix(mix(mix(a, b, u.x), mix(c, d, u.x), u.y), mix(mix(e, g, u.x), mix(h, k, u.x), u.y), u.z);
}

float latticeSlope(vec3 cell, vec3 corner, vec3 f) {
  return dot(hash33(cell + corner) * 2.0 - 1.0, f - corner);
}

// Perlin 2002, "Improving Noise", with gradients from the cube. 0 to 1, its mean 0.5.
float gradientNoise(vec3 p) {
  vec3 cell = floor(p), f = p - cell;
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float x00 = mix(latticeSlope(cell, vec3(0, 0, 0), f), latticeSlope(cell, vec3(1, 0, 0), f), u.x);
  float x10 = mix(latticeSlope(cell, vec3(0, 1, 0), f), latticeSlope(cell, vec3(1, 1, 0), f), u.x);
  float x01 = mix(latticeSlope(cell, vec3(0, 0, 1), f), latticeSlope(cell, vec3(1, 0, 1), f), u.x);
  float x11 = mix(latticeSlope(cell, vec3(0, 1, 1), f), latticeSlope(cell, vec3(1, 1, 1), f), u.x);
  return clamp(0.5 + 0.6 * mix(mix(x00, x10, u.y), mix(x01, x11, u.y), u.z), 0.0, 1.0);
}

// One octave more of a sum of noise: each is `fade` times as strong as the last and about twice as fine, its lattice
// moved, so that the octaves' lattices do not meet. Octaves are written out, not looped over: with more than a dozen
// loops in one shader LLVM's scalar evolution, which doubles its work with each, no longer comes to an end.
void addOctave(bool gradient, float fade, inout vec3 p, inout float weight, inout float sum,
               inout float total) {
  sum += weight * (gradient ? gradientNoise(p) : valueNoise(p));
  total += weight;
  weight *= fade;
  p = p * 2.03 + vec3(17.3, 5.1, 11.7);
}

// Up to eight octaves of noise, on gradients or on values. 0 to 1, its mean 0.5.
float fractalNoise(vec3 p, int octaves, bool gradient, float fade) {
  float weight = 1.0, sum = 0.0, total = 0.0;
  if (octaves > 0) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 1) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 2) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 3) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 4) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 5) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 6) addOctave(gradient, fade, p, weight, sum, total);
  if (octaves > 7) addOctave(gradient, fade, p, weight, sum, total);
  return clamp(sum / max(total, 1e-6), 0.0, 1.0);
}
