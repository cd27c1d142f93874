// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering": pcg3d, on the bits of a lattice point, so that
// every device gives the same numbers.
uvec3 pcg3d(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Three numbers in [0, 1) for a point with whole coordinates.
vec3 hash33(vec3 point) {
  return vec3(pcg3d(uvec3(ivec3(point))) >> 8u) * (1.0 / 16777216.0);
}
