/*glint
{
  "id": "blend-normals",
  "title": "Blend normals",
  "category": "Normal",
  "doc": "Detail upon a base normal, both in tangent space, without flattening either",
  "inputs": [
    {"name": "base", "type": "vec3", "default": [0, 0, 1], "min": -1, "max": 1},
    {"name": "detail", "type": "vec3", "default": [0, 0, 1], "min": -1, "max": 1}
  ],
  "outputs": [
    {"name": "normal", "type": "vec3"}
  ],
  "variance": "base + detail",
  "keywords": ["combine", "detail"]
}
*/
// Barre-Brisebois and Hill 2012, "Blending in Detail": reoriented normal mapping.
vec3 node_blend_normals(vec3 base, vec3 detail) {
  vec3 t = base + vec3(0.0, 0.0, 1.0);
  vec3 u = detail * vec3(-1.0, -1.0, 1.0);
  return normalize(t * dot(t, u) - u * max(t.z, 1e-4));
}
