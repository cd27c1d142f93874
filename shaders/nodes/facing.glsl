/*glint
{
  "id": "facing",
  "title": "Facing",
  "category": "Coordinates",
  "doc": "1 where the surface faces the camera, 0 at its outline",
  "inputs": [
    {"name": "power", "type": "float", "default": 1, "min": 0.1, "max": 8}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "surface": true,
  "keywords": ["view angle", "rim"]
}
*/
float node_facing(MaterialInputs i, float power) {
  return pow(clamp(dot(i.normal, i.view), 1e-4, 1.0), max(power, 1e-3));
}
