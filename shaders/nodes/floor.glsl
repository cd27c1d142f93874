/*glint
{
  "id": "floor",
  "title": "Floor",
  "category": "Math",
  "doc": "The next whole number below",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["round down"]
}
*/
T node_floor(T x) { return floor(x); }
