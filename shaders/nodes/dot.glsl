/*glint
{
  "id": "dot",
  "title": "Dot product",
  "category": "Vector",
  "doc": "The dot product of A and B",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["scalar product", "angle"]
}
*/
float node_dot(T a, T b) { return dot(a, b); }
