/*glint
{
  "id": "fract",
  "title": "Fraction",
  "category": "Math",
  "doc": "What is left above the whole number below",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["frac", "repeat"]
}
*/
T node_fract(T x) { return fract(x); }
