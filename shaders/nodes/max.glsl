/*glint
{
  "id": "max",
  "title": "Maximum",
  "category": "Math",
  "doc": "The larger of each component",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["larger"]
}
*/
T node_max(T a, T b) { return max(a, b); }
