/*glint
{
  "id": "world-tangent",
  "title": "World tangent",
  "category": "Coordinates",
  "doc": "The direction in which u grows, unit",
  "inputs": [
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true
}
*/
vec3 node_world_tangent(MaterialInputs i) { return i.tangent; }
