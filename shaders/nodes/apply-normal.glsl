/*glint
{
  "id": "apply-normal",
  "title": "World space normal",
  "category": "Normal",
  "doc": "A tangent-space normal as a direction in the world",
  "inputs": [
    {"name": "normal", "type": "vec3", "default": [0, 0, 1], "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true,
  "keywords": ["transform", "tangent"]
}
*/
vec3 node_apply_normal(MaterialInputs i, vec3 normal) {
  return normalize(normal.x * i.tangent + normal.y * i.bitangent + normal.z * i.normal);
}
