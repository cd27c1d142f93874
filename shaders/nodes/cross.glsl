/*glint
{
  "id": "cross",
  "title": "Cross product",
  "category": "Vector",
  "doc": "The vector at right angles to A and B",
  "inputs": [
    {"name": "a", "type": "vec3", "default": [1, 0, 0], "min": -1, "max": 1},
    {"name": "b", "type": "vec3", "default": [0, 1, 0], "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "vec3"}
  ]
}
*/
vec3 node_cross(vec3 a, vec3 b) { return cross(a, b); }
