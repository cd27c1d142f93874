/*glint
{
  "id": "min",
  "title": "Minimum",
  "category": "Math",
  "doc": "The smaller of each component",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["smaller"]
}
*/
T node_min(T a, T b) { return min(a, b); }
