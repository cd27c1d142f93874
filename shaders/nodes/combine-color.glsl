/*glint
{
  "id": "combine-color",
  "title": "Combine color",
  "category": "Vector",
  "doc": "A colour from red, green and blue, linear Rec.709",
  "inputs": [
    {"name": "r", "title": "Red", "type": "float", "default": 0},
    {"name": "g", "title": "Green", "type": "float", "default": 0},
    {"name": "b", "title": "Blue", "type": "float", "default": 0}
  ],
  "outputs": [
    {"name": "value", "type": "color"}
  ],
  "keywords": ["append", "rgb", "make"]
}
*/
vec3 node_combine_color(float r, float g, float b) { return vec3(r, g, b); }
