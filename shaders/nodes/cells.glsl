/*glint
{
  "id": "cells",
  "title": "Cells",
  "category": "Pattern",
  "doc": "Random cells in space (Worley, Voronoi)",
  "inputs": [
    {"name": "position", "type": "vec3", "default": "localPosition", "doc": "Where the pattern is read, in metres"},
    {"name": "scale", "type": "float", "default": 4, "min": 0, "max": 50, "doc": "Features per metre"},
    {"name": "jitter", "type": "float", "default": 1, "min": 0, "max": 1, "doc": "0 is a regular lattice"}
  ],
  "outputs": [
    {"name": "distance", "type": "float", "doc": "To the nearest point, 0 to about 1"},
    {"name": "edge", "type": "float", "doc": "0 on the border between cells"},
    {"name": "random", "type": "float", "doc": "One number for each cell"}
  ],
  "includes": ["hash"],
  "keywords": ["voronoi", "worley", "cellular", "cracks"]
}
*/
void cellPoint(vec3 cell, vec3 f, vec3 offset, float jitter, inout vec2 nearest, inout float random) {
  vec3 h = hash33(cell + offset);
  vec3 d = offset + 0.5 + (h - 0.5) * jitter - f;
  float d2 = dot(d, d);
  random = mix(random, h.x, d2 < nearest.x);
  nearest = vec2(min(nearest.x, d2), min(nearest.y, max(nearest.x, d2)));
}

void cellRow(vec3 cell, vec3 f, float y, float z, float jitter, inout vec2 nearest, inout float random) {
  cellPoint(cell, f, vec3(-1, y, z), jitter, nearest, random);
  cellPoint(cell, f, vec3(0, y, z), jitter, nearest, random);
  cellPoint(cell, f, vec3(1, y, z), jitter, nearest, random);
}

void cellSlice(vec3 cell, vec3 f, float z, float jitter, inout vec2 nearest, inout float random) {
  cellRow(cell, f, -1.0, z, jitter, nearest, random);
  cellRow(cell, f, 0.0, z, jitter, nearest, random);
  cellRow(cell, f, 1.0, z, jitter, nearest, random);
}

// Worley 1996, "A Cellular Texture Basis Function": the nearest two points of a jittered lattice. Written out and not
// looped over: see fractalNoise in lib/noise.glsl.
void node_cells(vec3 position, float scale, float jitter, out float distance, out float edge, out float random) {
  vec3 p = position * scale;
  vec3 cell = floor(p), f = p - cell;
  vec2 nearest = vec2(8.0);  // squared
  random = 0.0;
  cellSlice(cell, f, -1.0, jitter, nearest, random);
  cellSlice(cell, f, 0.0, jitter, nearest, random);
  cellSlice(cell, f, 1.0, jitter, nearest, random);
  distance = sqrt(nearest.x);
  edge = sqrt(nearest.y) - distance;
}
