/*glint
{
  "id": "power",
  "title": "Power",
  "category": "Math",
  "doc": "A to the power of B; a negative A counts as 0",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 1, "min": 0, "max": 1},
    {"name": "b", "type": "numeric", "default": 2, "min": 0, "max": 8}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["exponent", "gamma"]
}
*/
// pow() of 0 is not defined for an exponent of 0, nor of a negative base: both are kept out.
T node_power(T a, T b) { return pow(max(a, T(1e-30)), b); }
