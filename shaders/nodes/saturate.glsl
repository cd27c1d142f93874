/*glint
{
  "id": "saturate",
  "title": "Saturate",
  "category": "Math",
  "doc": "Keeps X between 0 and 1",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["clamp01"]
}
*/
T node_saturate(T x) { return clamp(x, T(0.0), T(1.0)); }
