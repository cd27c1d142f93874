/*glint
{
  "id": "world-normal",
  "title": "World normal",
  "category": "Coordinates",
  "doc": "The geometric normal, unit",
  "inputs": [
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true
}
*/
vec3 node_world_normal(MaterialInputs i) { return i.normal; }
