/*glint
{
  "id": "vertex-color",
  "title": "Vertex color",
  "category": "Coordinates",
  "doc": "The mesh's vertex colour and its alpha; white where it has none",
  "inputs": [
  ],
  "outputs": [
    {"name": "color", "type": "color"},
    {"name": "alpha", "type": "float"}
  ],
  "surface": true,
  "keywords": ["paint"]
}
*/
void node_vertex_color(MaterialInputs i, out vec3 color, out float alpha) {
  color = i.vertexColor.rgb;
  alpha = i.vertexColor.a;
}
