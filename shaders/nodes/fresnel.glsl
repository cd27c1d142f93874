/*glint
{
  "id": "fresnel",
  "title": "Fresnel",
  "category": "Coordinates",
  "doc": "How much a surface of this index of refraction mirrors at this angle, by Schlick's approximation",
  "inputs": [
    {"name": "ior", "title": "IOR", "type": "float", "default": 1.5, "min": 1, "max": 3}
  ],
  "outputs": [
    {"name": "value", "type": "float"}
  ],
  "surface": true,
  "keywords": ["rim", "reflectance"]
}
*/
// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15.
float node_fresnel(MaterialInputs i, float ior) {
  float r = (ior - 1.0) / max(ior + 1.0, 1e-3);
  float F0 = r * r;
  float m = 1.0 - clamp(dot(i.normal, i.view), 0.0, 1.0);
  float m2 = m * m;
  return F0 + (1.0 - F0) * m2 * m2 * m;
}
