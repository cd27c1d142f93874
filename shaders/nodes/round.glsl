/*glint
{
  "id": "round",
  "title": "Round",
  "category": "Math",
  "doc": "The nearest whole number",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ]
}
*/
T node_round(T x) { return floor(x + 0.5); }
