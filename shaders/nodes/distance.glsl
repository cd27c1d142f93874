/*glint
{
  "id": "distance",
  "title": "Distance",
  "category": "Vector",
  "doc": "The distance between two points",
  "inputs": [
    {"name": "a", "type": "numeric", "default": 0, "min": -1, "max": 1},
    {"name": "b", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ]
}
*/
float node_distance(T a, T b) { return distance(a, b); }
