/*glint
{
  "id": "sqrt",
  "title": "Square root",
  "category": "Math",
  "doc": "The square root; of a negative number 0",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["root"]
}
*/
T node_sqrt(T x) { return sqrt(max(x, T(0.0))); }
