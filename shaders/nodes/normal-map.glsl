/*glint
{
  "id": "normal-map",
  "title": "Normal map",
  "category": "Normal",
  "doc": "A tangent-space normal from a texture's colour, which must be sampled as linear data",
  "inputs": [
    {"name": "color", "type": "vec3", "default": [0.5, 0.5, 1]},
    {"name": "strength", "type": "float", "default": 1, "min": 0, "max": 4}
  ],
  "outputs": [
    {"name": "normal", "type": "vec3"}
  ],
  "settings": [
    {"name": "green", "type": "choice", "values": ["opengl", "directx"], "default": "opengl", "doc": "Whether green grows upwards (OpenGL, glTF) or downwards (DirectX, Unreal)"}
  ],
  "variance": "color * strength * strength",
  "keywords": ["bump", "tangent", "directx", "opengl"]
}
*/
// z is made from x and y: two-channel maps have none, and eight bits store a poor one.
vec3 node_normal_map(vec3 color, float strength, int green) {
  vec2 xy = color.xy * 2.0 - 1.0;
  if (green == 1) xy.y = -xy.y;
  float z = sqrt(max(1.0 - dot(xy, xy), 0.0));
  return normalize(vec3(xy * strength, max(z, 1e-3)));
}
