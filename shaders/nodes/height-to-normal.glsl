/*glint
{
  "id": "height-to-normal",
  "title": "Height to normal",
  "category": "Normal",
  "doc": "A tangent-space normal from a height, by how it changes from pixel to pixel",
  "inputs": [
    {"name": "height", "type": "float", "default": 0, "min": -1, "max": 1, "doc": "Metres, times the strength"},
    {"name": "strength", "type": "float", "default": 1, "min": 0, "max": 10}
  ],
  "outputs": [
    {"name": "normal", "type": "vec3"}
  ],
  "surface": true,
  "keywords": ["bump"]
}
*/
// Mikkelsen 2010, "Bump Mapping Unparametrized Surfaces on the GPU", eqs. 1 to 7: the surface's gradient from
// screen-space differences, which needs no texture coordinates. Turned into tangent space at the end.
vec3 node_height_to_normal(MaterialInputs i, float height, float strength) {
  vec3 sigmaX = dFdx(i.position), sigmaY = dFdy(i.position);
  float dHx = dFdx(height) * strength, dHy = dFdy(height) * strength;
  vec3 r1 = cross(sigmaY, i.normal), r2 = cross(i.normal, sigmaX);
  float det = dot(sigmaX, r1);
  vec3 gradient = sign(det) * (dHx * r1 + dHy * r2);
  vec3 n = normalize(max(abs(det), 1e-20) * i.normal - gradient);
  return normalize(vec3(dot(n, i.tangent), dot(n, i.bitangent), max(dot(n, i.normal), 1e-3)));
}
