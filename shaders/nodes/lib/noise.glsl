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

// Octaves of gradient noise, each half as strong and about twice as fine. 0 to 1.
float fractalNoise(vec3 p, int octaves) {
  float sum = 0.0, weight = 0.5, total = 0.0;
  for (int o = 0; o < octaves; ++o) {
    sum += weight * gradientNoise(p);
    total += weight;
    weight *= 0.5;
    p = p * 2.03 + vec3(17.3, 5.1, 11.7);
  }
  return sum / total;
}
