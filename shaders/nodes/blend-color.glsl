/*glint
{
  "id": "blend-color",
  "title": "Blend colors",
  "category": "Color",
  "doc": "One colour upon another, as in a painting program, on linear colours",
  "inputs": [
    {"name": "base", "type": "color", "default": 0.5},
    {"name": "blend", "type": "color", "default": 0.5},
    {"name": "mask", "type": "float", "default": 1, "min": 0, "max": 1}
  ],
  "outputs": [
    {"name": "value", "type": "color"}
  ],
  "settings": [
    {"name": "mode", "type": "choice", "values": ["normal", "multiply", "screen", "overlay", "lighten", "darken", "add"], "default": "normal", "doc": "How the two meet"}
  ],
  "keywords": ["overlay", "multiply", "screen", "photoshop"]
}
*/
vec3 node_blend_color(vec3 base, vec3 blend, float mask, int mode) {
  vec3 result = blend;
  if (mode == 1) result = base * blend;
  else if (mode == 2) result = 1.0 - (1.0 - base) * (1.0 - blend);
  else if (mode == 3) result = mix(2.0 * base * blend, 1.0 - 2.0 * (1.0 - base) * (1.0 - blend), step(0.5, base));
  else if (mode == 4) result = max(base, blend);
  else if (mode == 5) result = min(base, blend);
  else if (mode == 6) result = base + blend;
  return mix(base, result, clamp(mask, 0.0, 1.0));
}
