/*glint
{
  "id": "grunge",
  "title": "Grunge",
  "category": "Mask",
  "doc": "Blotches of dirt at several sizes, 0 to 1, more of it with a higher amount",
  "inputs": [
    {"name": "position", "type": "vec3", "default": "localPosition", "doc": "Where the pattern is read, in metres"},
    {"name": "scale", "type": "float", "default": 3, "min": 0, "max": 50, "doc": "Features per metre"},
    {"name": "amount", "type": "float", "default": 0.5, "min": 0, "max": 1, "doc": "How much of the surface is covered"},
    {"name": "softness", "type": "float", "default": 0.2, "min": 0.01, "max": 1, "doc": "Of the edges"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "includes": ["hash", "noise"],
  "keywords": ["dirt", "wear", "rust"]
}
*/
// Fractal noise bent by fractal noise, cut at the level that covers about `amount` of the surface.
float node_grunge(vec3 position, float scale, float amount, float softness) {
  vec3 p = position * scale;
  vec3 bend = vec3(gradientNoise(p), gradientNoise(p + 31.4), gradientNoise(p + 57.1)) - 0.5;
  float n = fractalNoise(p * 1.7 + bend * 2.5, 5, true, 0.5);
  // 4.5 maps the noise's spread (deviation about 0.11) onto 0..1.
  float spread = clamp((n - 0.5) * 4.5 + 0.5, 0.0, 1.0);
  float edge = max(softness, 1e-3) * 0.5;
  float cut = mix(1.0 + edge, -edge, clamp(amount, 0.0, 1.0));
  return smoothstep(cut - edge, cut + edge, spread);
}
