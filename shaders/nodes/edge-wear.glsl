/*glint
{
  "id": "edge-wear",
  "title": "Edge wear",
  "category": "Mask",
  "doc": "Where paint has come off: chips along the borders of cells and ragged patches",
  "inputs": [
    {"name": "position", "type": "vec3", "default": "localPosition", "doc": "Where the pattern is read, in metres"},
    {"name": "scale", "type": "float", "default": 5, "min": 0, "max": 50, "doc": "Features per metre"},
    {"name": "amount", "type": "float", "default": 0.3, "min": 0, "max": 1, "doc": "How much has come off"},
    {"name": "raggedness", "type": "float", "default": 0.5, "min": 0, "max": 1, "doc": "How torn the borders are"}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "includes": ["hash", "noise"],
  "keywords": ["scratch", "chipped", "paint"]
}
*/
// A mesh has no curvature to look up here, so the wear is where a warped cellular pattern has its edges.
float node_edge_wear(vec3 position, float scale, float amount, float raggedness) {
  vec3 p = position * scale;
  float torn = fractalNoise(p * 3.1, 4, true, 0.5) - 0.5;
  float patches = fractalNoise(p * 0.6 + 9.2, 3, true, 0.5) - 0.5;
  float field = 0.5 + patches * 2.2 + torn * raggedness * 1.6;
  float cut = mix(1.15, -0.15, clamp(amount, 0.0, 1.0));
  return smoothstep(cut - 0.03, cut + 0.03, field);
}
