/*glint
{
  "id": "smoothstep",
  "title": "Smooth step",
  "category": "Math",
  "doc": "0 below the low edge, 1 above the high one, an S between",
  "inputs": [
    {"name": "low", "type": "numeric", "default": 0, "min": 0, "max": 1},
    {"name": "high", "type": "numeric", "default": 1, "min": 0, "max": 1},
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["threshold", "ease"]
}
*/
// GLSL leaves smoothstep() undefined where its edges meet.
T node_smoothstep(T low, T high, T x) {
  T t = clamp((x - low) / max(high - low, T(1e-6)), T(0.0), T(1.0));
  return t * t * (3.0 - 2.0 * t);
}
