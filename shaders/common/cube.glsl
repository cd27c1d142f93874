// The direction (not unit) through a point of a cube map's face, p in 0..1 (OpenGL 4.5, table 8.19).
vec3 cubeDirection(int face, vec2 p) {
  vec2 q = 2.0 * p - 1.0;
  if (face == 0) return vec3(1.0, -q.y, -q.x);
  if (face == 1) return vec3(-1.0, -q.y, q.x);
  if (face == 2) return vec3(q.x, 1.0, q.y);
  if (face == 3) return vec3(q.x, -1.0, -q.y);
  if (face == 4) return vec3(q.x, -q.y, 1.0);
  return vec3(-q.x, -q.y, -1.0);
}
