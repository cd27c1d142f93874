/*glint
{
  "id": "modulo",
  "title": "Modulo",
  "category": "Math",
  "doc": "What is left of A after whole multiples of B; follows the sign of B",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["remainder", "repeat"]
}
*/
T node_modulo(T a, T b) { return mod(a, max(abs(b), T(1e-6))); }
