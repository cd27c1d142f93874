/*glint
{
  "id": "brick",
  "title": "Brick",
  "category": "Pattern",
  "doc": "Rows of bricks: 1 on a brick, 0 in the mortar, and one random number for each brick",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"},
    {"name": "count", "type": "vec2", "default": [4, 8], "min": 1, "max": 64, "doc": "Bricks over one tile"},
    {"name": "mortar", "type": "float", "default": 0.05, "min": 0, "max": 0.5, "doc": "Its width in parts of a brick"},
    {"name": "shift", "type": "float", "default": 0.5, "min": 0, "max": 1, "doc": "Of every second row"}
  ],
  "outputs": [
    {"name": "mask", "type": "float"},
    {"name": "random", "type": "float"}
  ],
  "includes": ["hash"],
  "keywords": ["tiles", "wall"]
}
*/
void node_brick(vec2 uv, vec2 count, float mortar, float shift, out float mask, out float random) {
  vec2 p = uv * count;
  p.x += mod(floor(p.y), 2.0) * shift;
  vec2 cell = floor(p), f = p - cell;
  vec2 edge = min(f, 1.0 - f) * vec2(1.0, count.x / max(count.y, 1e-3));
  float w = max(mortar * 0.5, 1e-4);
  mask = smoothstep(w * 0.8, w * 1.2, min(edge.x, edge.y));
  random = hash33(vec3(cell, 0.0)).x;
}
