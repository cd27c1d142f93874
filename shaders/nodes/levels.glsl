/*glint
{
  "id": "levels",
  "title": "Levels",
  "category": "Color",
  "doc": "Black and white point, then a gamma; the result is between 0 and 1",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0.5, "min": 0, "max": 1},
    {"name": "low", "title": "Black", "type": "float", "default": 0, "min": 0, "max": 1},
    {"name": "high", "title": "White", "type": "float", "default": 1, "min": 0, "max": 1},
    {"name": "gamma", "type": "float", "default": 1, "min": 0.1, "max": 8}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "includes": ["compare"],
  "keywords": ["curve", "threshold"]
}
*/
T node_levels(T x, float low, float high, float gamma) {
  T t = clamp((x - low) / abs_at_least(high - low, 1e-5), T(0.0), T(1.0));
  return pow(max(t, T(1e-30)), T(1.0 / max(gamma, 1e-3)));
}
