/*glint
{
  "id": "remap",
  "title": "Remap",
  "category": "Math",
  "doc": "Moves a range onto another; outside of it the line goes on, unless clamped",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "fromLow", "type": "numeric", "default": 0},
    {"name": "fromHigh", "type": "numeric", "default": 1},
    {"name": "toLow", "type": "numeric", "default": 0},
    {"name": "toHigh", "type": "numeric", "default": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "settings": [
    {"name": "clamped", "type": "bool", "default": true, "doc": "Stay within the new range"}
  ],
  "includes": ["compare"],
  "keywords": ["fit", "range", "levels"]
}
*/
T node_remap(T x, T fromLow, T fromHigh, T toLow, T toHigh, bool clamped) {
  T span = fromHigh - fromLow;
  T t = (x - fromLow) / (abs_at_least(span, 1e-6));
  return mix(toLow, toHigh, clamped ? clamp(t, T(0.0), T(1.0)) : t);
}
