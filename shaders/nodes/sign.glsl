/*glint
{
  "id": "sign",
  "title": "Sign",
  "category": "Math",
  "doc": "-1, 0 or 1",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ]
}
*/
T node_sign(T x) { return sign(x); }
