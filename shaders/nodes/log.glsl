/*glint
{
  "id": "log",
  "title": "Logarithm",
  "category": "Math",
  "doc": "The natural logarithm; of what is not positive as of 1e-30",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ]
}
*/
T node_log(T x) { return log(max(x, T(1e-30))); }
