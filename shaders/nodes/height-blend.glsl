/*glint
{
  "id": "height-blend",
  "title": "Height blend mask",
  "category": "Mask",
  "doc": "A mask that lets the higher of two surfaces show through first",
  "inputs": [
    {"name": "mask", "type": "float", "default": 0.5, "min": 0, "max": 1},
    {"name": "heightA", "type": "float", "default": 0.5, "min": 0, "max": 1},
    {"name": "heightB", "type": "float", "default": 0.5, "min": 0, "max": 1},
    {"name": "contrast", "type": "float", "default": 0.8, "min": 0, "max": 1, "doc": "1 is a hard edge"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["layer", "mask"]
}
*/
float node_height_blend(float mask, float heightA, float heightB, float contrast) {
  float a = heightA + 1.0 - mask, b = heightB + mask;
  float edge = max((1.0 - clamp(contrast, 0.0, 1.0)) * 0.5, 1e-3);
  return smoothstep(-edge, edge, b - a);
}
