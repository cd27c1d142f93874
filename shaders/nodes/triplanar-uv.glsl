/*glint
{
  "id": "triplanar-uv",
  "title": "Box UV",
  "category": "Coordinates",
  "doc": "Texture coordinates from the side of a box that the surface faces, for meshes without their own",
  "inputs": [
    {"name": "position", "type": "vec3", "default": "localPosition"},
    {"name": "normal", "type": "vec3", "default": "normal"},
    {"name": "scale", "type": "float", "default": 1, "min": 0, "max": 20, "doc": "Tiles per metre"}
  ],
  "outputs": [
    {"name": "value", "type": "vec2"}
  ],
  "keywords": ["box", "cube", "projection"]
}
*/
vec2 node_triplanar_uv(vec3 position, vec3 normal, float scale) {
  vec3 n = abs(normal);
  vec2 uv = n.x > n.y && n.x > n.z ? position.zy : n.y > n.z ? position.xz : position.xy;
  return vec2(uv.x, -uv.y) * scale;
}
