/*glint
{
  "id": "slope-mask",
  "title": "Slope mask",
  "category": "Mask",
  "doc": "1 where the surface faces a direction: snow and dust from above",
  "inputs": [
    {"name": "direction", "type": "vec3", "default": [0, 1, 0], "min": -1, "max": 1},
    {"name": "angle", "type": "float", "default": 60, "min": 0, "max": 180, "doc": "Degrees from the direction where it ends"},
    {"name": "softness", "type": "float", "default": 20, "min": 0, "max": 90, "doc": "Degrees over which it fades"},
    {"name": "normal", "type": "vec3", "default": "normal", "doc": "In the world"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["snow", "dust", "up"]
}
*/
float node_slope_mask(vec3 direction, float angle, float softness, vec3 normal) {
  vec3 d = direction * inversesqrt(max(dot(direction, direction), 1e-20));
  float degreesAway = degrees(acos(clamp(dot(normal, d), -1.0, 1.0)));
  float s = max(softness, 1e-3);
  return 1.0 - smoothstep(angle - 0.5 * s, angle + 0.5 * s, degreesAway);
}
