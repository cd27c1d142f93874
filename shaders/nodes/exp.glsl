/*glint
{
  "id": "exp",
  "title": "Exponential",
  "category": "Math",
  "doc": "e to the power of X",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ]
}
*/
T node_exp(T x) { return exp(min(x, T(80.0))); }
