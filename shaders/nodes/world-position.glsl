/*glint
{
  "id": "world-position",
  "title": "World position",
  "category": "Coordinates",
  "doc": "Where the point is, in metres",
  "inputs": [
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true
}
*/
vec3 node_world_position(MaterialInputs i) { return i.position; }
