#version 450 core
// Rectangles of the target, one instance each: the whole view, or the tiles of the light lists.
layout(location = 0) in ivec4 tile;     // x0, y0, x1, y1: pixels
layout(location = 1) in ivec4 lights;   // first texel of the light list and how many of each kind (renderer/light_tiles.h)
uniform vec2 targetSize;
layout(location = 0) flat out ivec4 outLights;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? tile.x : tile.z, (gl_VertexID & 2) == 0 ? tile.y : tile.w);
  outLights = lights;
  gl_Position = vec4(corner / targetSize * 2.0 - 1.0, 0.0, 1.0);
}
