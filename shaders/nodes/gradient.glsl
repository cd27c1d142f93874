/*glint
{
  "id": "gradient",
  "title": "Gradient",
  "category": "Pattern",
  "doc": "From 0 to 1 along u, v, around the centre of the tile or out from it",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "settings": [
    {"name": "shape", "type": "choice", "values": ["u", "v", "radial", "angular"], "default": "u", "doc": "Which way it runs"}
  ],
  "keywords": ["ramp", "radial"]
}
*/
float node_gradient(vec2 uv, int shape) {
  vec2 p = uv - 0.5;
  if (shape == 0) return clamp(uv.x, 0.0, 1.0);
  if (shape == 1) return clamp(uv.y, 0.0, 1.0);
  if (shape == 2) return clamp(length(p) * 2.0, 0.0, 1.0);
  return fract(atan(p.y, dot(p, p) > 0.0 ? p.x : 1.0) / 6.28318531 + 0.5);
}
