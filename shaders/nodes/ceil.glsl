/*glint
{
  "id": "ceil",
  "title": "Ceiling",
  "category": "Math",
  "doc": "The next whole number above",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["round up"]
}
*/
T node_ceil(T x) { return ceil(x); }
