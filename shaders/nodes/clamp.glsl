/*glint
{
  "id": "clamp",
  "title": "Clamp",
  "category": "Math",
  "doc": "Keeps X between two bounds",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "low", "type": "numeric", "default": 0},
    {"name": "high", "type": "numeric", "default": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["limit"]
}
*/
T node_clamp(T x, T low, T high) { return clamp(x, low, high); }
