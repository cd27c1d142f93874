/*glint
{
  "id": "sin",
  "title": "Sine",
  "category": "Math",
  "doc": "The sine of X; X in radians",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["wave"]
}
*/
T node_sin(T x) { return sin(x); }
