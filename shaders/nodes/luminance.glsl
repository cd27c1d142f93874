/*glint
{
  "id": "luminance",
  "title": "Luminance",
  "category": "Color",
  "doc": "How bright a colour looks: its Y in Rec.709",
  "inputs": [
    {"name": "color", "type": "color", "default": 0}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "keywords": ["grey", "desaturate", "brightness"]
}
*/
// IEC 61966-2-1: the Y of linear Rec.709 primaries under D65.
float node_luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }
