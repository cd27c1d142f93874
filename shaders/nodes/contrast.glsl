/*glint
{
  "id": "contrast",
  "title": "Contrast",
  "category": "Color",
  "doc": "Spreads values about a middle",
  "inputs": [
    {"name": "x", "type": "numeric", "default": 0.5, "min": 0, "max": 1},
    {"name": "contrast", "type": "float", "default": 1, "min": 0, "max": 8},
    {"name": "middle", "type": "float", "default": 0.5, "min": 0, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "numeric"}
  ]
}
*/
T node_contrast(T x, float contrast, float middle) { return (x - middle) * contrast + middle; }
