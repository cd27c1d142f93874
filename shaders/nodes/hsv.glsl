/*glint
{
  "id": "hsv",
  "title": "Hue, saturation, value",
  "category": "Color",
  "doc": "Turns the hue and scales saturation and value of a colour",
  "inputs": [
    {"name": "color", "type": "color", "default": 0.5},
    {"name": "hue", "type": "float", "default": 0, "min": -180, "max": 180, "doc": "Degrees"},
    {"name": "saturation", "type": "float", "default": 1, "min": 0, "max": 4},
    {"name": "value", "type": "float", "default": 1, "min": 0, "max": 4}
  ],
  "outputs": [
    {"name": "result", "type": "color"}
  ],
  "keywords": ["hue", "saturation", "adjust"]
}
*/
// Smith 1978, "Color Gamut Transform Pairs": hue as a hexagon.
vec3 node_hsv(vec3 color, float hue, float saturation, float value) {
  vec3 c = max(color, vec3(0.0));
  float high = max(c.r, max(c.g, c.b)), low = min(c.r, min(c.g, c.b)), chroma = high - low;
  float h = 0.0;
  if (chroma > 1e-6) {
    if (high == c.r) h = mod((c.g - c.b) / chroma, 6.0);
    else if (high == c.g) h = (c.b - c.r) / chroma + 2.0;
    else h = (c.r - c.g) / chroma + 4.0;
  }
  h = h / 6.0 + hue / 360.0;
  float s = clamp(high > 0.0 ? chroma / high * saturation : 0.0, 0.0, 1.0);
  vec3 k = clamp(abs(mod(h * 6.0 + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0);
  return high * value * mix(vec3(1.0), k, s);
}
