/*glint
{
  "id": "length",
  "title": "Length",
  "category": "Vector",
  "doc": "The length of a vector",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0, "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["magnitude"]
}
*/
float node_length(T x) { return length(x); }
