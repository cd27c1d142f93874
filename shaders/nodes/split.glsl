/*glint
{
  "id": "split",
  "title": "Split",
  "category": "Vector",
  "doc": "The single components; those that a vector does not have are 0",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "x", "title": "X", "type": "float"},
    {"name": "y", "title": "Y", "type": "float"},
    {"name": "z", "title": "Z", "type": "float"},
    {"name": "w", "title": "W", "type": "float"}
  ],
  "includes": ["widen"],
  "keywords": ["separate", "component", "break", "mask", "rgb"]
}
*/
void node_split(T x, out float xOut, out float yOut, out float zOut, out float wOut) {
  vec4 v = widened(x);
  xOut = v.x;
  yOut = v.y;
  zOut = v.z;
  wOut = v.w;
}
