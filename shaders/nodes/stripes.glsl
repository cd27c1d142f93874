/*glint
{
  "id": "stripes",
  "title": "Stripes",
  "category": "Pattern",
  "doc": "Lines along v, with soft edges",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"},
    {"name": "count", "type": "float", "default": 8, "min": 0, "max": 64},
    {"name": "width", "type": "float", "default": 0.5, "min": 0, "max": 1},
    {"name": "softness", "type": "float", "default": 0.05, "min": 0, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["lines", "bars"]
}
*/
float node_stripes(vec2 uv, float count, float width, float softness) {
  float d = abs(fract(uv.x * count) - 0.5) * 2.0;
  float s = max(softness, 1e-4) * 0.5;
  return 1.0 - smoothstep(width - s, width + s, d);
}
