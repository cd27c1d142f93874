/*glint
{
  "id": "abs",
  "title": "Absolute",
  "category": "Math",
  "doc": "X without its sign",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["magnitude"]
}
*/
T node_abs(T x) { return abs(x); }
