/*glint
{
  "id": "ramp",
  "title": "Color ramp",
  "category": "Color",
  "doc": "A colour along three stops",
  "inputs": [
    {"name": "t", "type": "float", "default": 0.5, "min": 0, "max": 1},
    {"name": "low", "type": "color", "default": 0},
    {"name": "middle", "type": "color", "default": 0.5},
    {"name": "high", "type": "color", "default": 1},
    {"name": "position", "type": "float", "default": 0.5, "min": 0, "max": 1, "doc": "Of the middle stop"}
  ],
  "outputs": [
    {"name": "value", "type": "color"}
  ],
  "keywords": ["gradient", "map"]
}
*/
vec3 node_ramp(float t, vec3 low, vec3 middle, vec3 high, float position) {
  float p = clamp(position, 1e-3, 1.0 - 1e-3), x = clamp(t, 0.0, 1.0);
  return x < p ? mix(low, middle, x / p) : mix(middle, high, (x - p) / (1.0 - p));
}
