/*glint
{
  "id": "cos",
  "title": "Cosine",
  "category": "Math",
  "doc": "The cosine of X; X in radians",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["wave"]
}
*/
T node_cos(T x) { return cos(x); }
