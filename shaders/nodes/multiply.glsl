/*glint
{
  "id": "multiply",
  "title": "Multiply",
  "category": "Math",
  "doc": "The product A B",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 1, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["times", "scale", "tint"]
}
*/
T node_multiply(T a, T b) { return a * b; }
