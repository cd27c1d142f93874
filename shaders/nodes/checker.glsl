/*glint
{
  "id": "checker",
  "title": "Checker",
  "category": "Pattern",
  "doc": "Squares in turn",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"},
    {"name": "scale", "type": "vec2", "default": 8, "min": 0, "max": 64, "doc": "Squares over one tile"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["chess", "tiles"]
}
*/
float node_checker(vec2 uv, vec2 scale) {
  vec2 cell = floor(uv * scale);
  return mod(cell.x + cell.y, 2.0);
}
