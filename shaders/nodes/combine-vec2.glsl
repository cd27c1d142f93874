/*glint
{
  "id": "combine-vec2",
  "title": "Combine 2",
  "category": "Vector",
  "doc": "A vector of 2 components",
  "inputs": [
    {"name": "x", "title": "X", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "y", "title": "Y", "type": "float", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "vec2"}
  ],
  "keywords": ["append", "make", "join"]
}
*/
vec2 node_combine_vec2(float x, float y) { return vec2(x, y); }
