/*glint
{
  "id": "subtract",
  "title": "Subtract",
  "category": "Math",
  "doc": "The difference A - B",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["minus", "difference"]
}
*/
T node_subtract(T a, T b) { return a - b; }
