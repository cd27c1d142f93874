/*glint
{
  "id": "combine-vec3",
  "title": "Combine 3",
  "category": "Vector",
  "doc": "A vector of 3 components",
  "inputs": [
    {"name": "x", "title": "X", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "y", "title": "Y", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "z", "title": "Z", "type": "float", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ],
  "keywords": ["append", "make", "join"]
}
*/
vec3 node_combine_vec3(float x, float y, float z) { return vec3(x, y, z); }
