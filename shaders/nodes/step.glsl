/*glint
{
  "id": "step",
  "title": "Step",
  "category": "Math",
  "doc": "0 below the edge, 1 from it on",
  "inputs": [
    {"name": "edge", "type": "numeric", "default": 0.5, "min": 0, "max": 1},
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ],
  "keywords": ["threshold", "compare", "if"]
}
*/
T node_step(T edge, T x) { return step(edge, x); }
