/*glint
{
  "id": "normalize",
  "title": "Normalize",
  "category": "Vector",
  "doc": "The vector with length 1; 0 stays 0",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["unit"]
}
*/
T node_normalize(T x) { return x * inversesqrt(max(dot(x, x), 1e-30)); }
