/*glint
{
  "id": "view-direction",
  "title": "View direction",
  "category": "Coordinates",
  "doc": "To the camera, unit",
  "inputs": [
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "surface": true
}
*/
vec3 node_view_direction(MaterialInputs i) { return i.view; }
