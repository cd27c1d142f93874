/*glint
{
  "id": "local-position",
  "title": "Local position",
  "category": "Coordinates",
  "doc": "Where the point is in the mesh's own space, in metres: patterns stay with the object",
  "inputs": [
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true
}
*/
vec3 node_local_position(MaterialInputs i) { return i.localPosition; }
