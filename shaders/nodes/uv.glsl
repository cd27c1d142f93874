/*glint
{
  "id": "uv",
  "title": "UV",
  "category": "Coordinates",
  "doc": "A texture coordinate of the mesh",
  "inputs": [
  ],
  "outputs": [
    {"name": "uv", "title": "UV", "type": "vec2"}
  ],
  "settings": [
    {"name": "set", "type": "choice", "values": ["uv0", "uv1"], "default": "uv0", "doc": "Which of the mesh's coordinates"}
  ],
  "surface": true,
  "keywords": ["texcoord", "texture coordinate"]
}
*/
vec2 node_uv(MaterialInputs i, int set) { return set == 0 ? i.uv0 : i.uv1; }
