/*glint
{
  "id": "divide",
  "title": "Divide",
  "category": "Math",
  "doc": "A over B, component by component; 0 where B is 0",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 1, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 1, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "includes": ["compare"],
  "keywords": ["over", "ratio"]
}
*/
// 0 is taken out of the divisor first: a division by it would still be computed, and NaN spreads.
T node_divide(T a, T b) {
  T isZero = T(equal_zero(b));
  return (1.0 - isZero) * a / (b + isZero);
}
