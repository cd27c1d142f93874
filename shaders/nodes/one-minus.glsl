/*glint
{
  "id": "one-minus",
  "title": "One minus",
  "category": "Math",
  "doc": "1 - X",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["invert", "complement"]
}
*/
T node_one_minus(T x) { return 1.0 - x; }
