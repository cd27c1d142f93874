/*glint
{
  "id": "noise",
  "title": "Noise",
  "category": "Pattern",
  "doc": "A soft random pattern in space, 0 to 1, its mean 0.5",
  "inputs": [
    {"name": "position", "type": "vec3", "default": "localPosition", "doc": "Where the pattern is read, in metres"},
    {"name": "scale", "type": "float", "default": 4, "min": 0, "max": 50, "doc": "Features per metre"},
    {"name": "roughness", "type": "float", "default": 0.5, "min": 0, "max": 1, "doc": "How strong each finer octave is"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "settings": [
    {"name": "type", "type": "choice", "values": ["perlin", "value"], "default": "perlin", "doc": "Gradients or values at the lattice's points"},
    {"name": "octaves", "type": "int", "min": 1, "max": 8, "default": 3, "doc": "How many finer copies are added; each costs as much as the first"}
  ],
  "includes": ["hash", "noise"],
  "keywords": ["perlin", "fbm", "fractal", "clouds", "random"]
}
*/
float node_noise(vec3 position, float scale, float roughness, int type, int octaves) {
  return fractalNoise(position * scale, octaves, type == 0, roughness);
}
