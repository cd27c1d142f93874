/*glint
{
  "id": "mix",
  "title": "Mix",
  "category": "Math",
  "doc": "A where T is 0, B where it is 1, a straight line between",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": 0, "max": 1},
    {"name": "b", "type": "numeric", "default": 1, "min": 0, "max": 1},
    {"name": "t", "title": "Mask", "type": "numeric", "default": 0.5, "min": 0, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["lerp", "blend", "interpolate"]
}
*/
T node_mix(T a, T b, T t) { return mix(a, b, t); }
