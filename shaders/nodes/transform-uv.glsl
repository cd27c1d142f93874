/*glint
{
  "id": "transform-uv",
  "title": "Transform UV",
  "category": "Coordinates",
  "doc": "Scales about the centre of the tile, turns, then moves a texture coordinate",
  "inputs": [
    {"name": "uv", "title": "UV", "type": "vec2", "default": "uv0"},
    {"name": "tile", "type": "vec2", "default": 1, "min": 0, "max": 20, "doc": "How often it repeats"},
    {"name": "offset", "type": "vec2", "default": 0, "min": -1, "max": 1},
    {"name": "rotation", "type": "float", "default": 0, "min": -180, "max": 180, "doc": "Degrees, counterclockwise"}
  ],
  "outputs": [
    {"name": "value", "type": "vec2"}
  ],
  "keywords": ["tile", "offset", "rotate", "scale", "mapping"]
}
*/
vec2 node_transform_uv(vec2 uv, vec2 tile, vec2 offset, float rotation) {
  float c = cos(radians(rotation)), s = sin(radians(rotation));
  vec2 p = uv - 0.5;
  // v grows downwards, so counterclockwise on screen turns the other way round here.
  return vec2(c * p.x + s * p.y, c * p.y - s * p.x) * tile + 0.5 + offset;
}
