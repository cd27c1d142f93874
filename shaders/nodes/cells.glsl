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
// Worley 1996, "A Cellular Texture Basis Function": the nearest two points of a jittered lattice.
void node_cells(vec3 position, float scale, float jitter, out float distance, out float edge, out float random) {
  vec3 p = position * scale;
  vec3 cell = floor(p), f = p - cell;
  float first = 8.0, second = 8.0;
  random = 0.0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        vec3 offset = vec3(x, y, z);
        vec3 h = hash33(cell + offset);
        vec3 d = offset + 0.5 + (h - 0.5) * jitter - f;
        float d2 = dot(d, d);
        if (d2 < first) {
          second = first;
          first = d2;
          random = h.x;
        } else if (d2 < second) {
          second = d2;
        }
      }
  distance = sqrt(first);
  edge = sqrt(second) - distance;
}
