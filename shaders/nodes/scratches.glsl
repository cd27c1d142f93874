/*glint
{
  "id": "scratches",
  "title": "Scratches",
  "category": "Mask",
  "doc": "Thin lines in one direction, each with its own depth",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"},
    {"name": "density", "type": "float", "default": 40, "min": 1, "max": 400, "doc": "Lines over one tile"},
    {"name": "length", "type": "float", "default": 0.3, "min": 0.01, "max": 2, "doc": "In tiles"},
    {"name": "amount", "type": "float", "default": 0.5, "min": 0, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "includes": ["hash"],
  "keywords": ["brushed", "lines"]
}
*/
float scratchLayer(vec2 uv, float layer, float density, float length, float amount) {
  float turn = 0.12 * (layer - 1.0);
  vec2 p = vec2(uv.x + turn * uv.y, uv.y - turn * uv.x) * vec2(1.0 / max(length, 1e-3), density);
  vec2 cell = floor(p), f = p - cell;
  vec3 h = hash33(vec3(cell, layer * 7.0));
  float line = 1.0 - smoothstep(0.0, 0.12, abs(f.y - 0.2 - 0.6 * h.y));
  float ends = smoothstep(0.0, 0.2, f.x) * (1.0 - smoothstep(0.8, 1.0, f.x));
  return step(1.0 - amount, h.x) * line * ends * h.z;
}

float node_scratches(vec2 uv, float density, float length, float amount) {
  return max(max(scratchLayer(uv, 0.0, density, length, amount), scratchLayer(uv, 1.0, density, length, amount)),
             scratchLayer(uv, 2.0, density, length, amount));
}
