/*glint
{
  "id": "combine-vec4",
  "title": "Combine 4",
  "category": "Vector",
  "doc": "A vector of 4 components",
  "inputs": [
    {"name": "x", "title": "X", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "y", "title": "Y", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "z", "title": "Z", "type": "float", "default": 0, "min": -1, "max": 1},
    {"name": "w", "title": "W", "type": "float", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "vec4"}
  ],
  "keywords": ["append", "make", "join"]
}
*/
vec4 node_combine_vec4(float x, float y, float z, float w) { return vec4(x, y, z, w); }
