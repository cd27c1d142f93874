/*glint
{
  "id": "add",
  "title": "Add",
  "category": "Math",
  "doc": "The sum A + B",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["plus", "sum"]
}
*/
T node_add(T a, T b) { return a + b; }
