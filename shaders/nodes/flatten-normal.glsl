/*glint
{
  "id": "flatten-normal",
  "title": "Flatten normal",
  "category": "Normal",
  "doc": "Weakens a tangent-space normal",
  "inputs": [
    {"name": "normal", "type": "vec3", "default": [0, 0, 1], "min": -1, "max": 1},
    {"name": "flatness", "type": "float", "default": 0, "min": 0, "max": 1, "doc": "1 is flat"}
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "variance": "normal * (1.0 - flatness) * (1.0 - flatness)",
  "keywords": ["strength", "soften"]
}
*/
vec3 node_flatten_normal(vec3 normal, float flatness) {
  return normalize(mix(normal, vec3(0.0, 0.0, 1.0), clamp(flatness, 0.0, 1.0)));
}
