/*glint
{
  "id": "negate",
  "title": "Negate",
  "category": "Math",
  "doc": "-X",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["minus"]
}
*/
T node_negate(T x) { return -x; }
