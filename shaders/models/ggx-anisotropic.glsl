/*glint
{
  "id": "ggx-anisotropic",
  "title": "GGX (anisotropic)",
  "doc": "GGX with a highlight that is longer along the tangent: brushed metal, satin, hair-like grooves.",
  "color": [0.25, 0.72, 0.80],
  "parameters": [
    {
      "name": "anisotropy",
      "title": "Anisotropy",
      "type": "float",
      "min": -1,
      "max": 1,
      "default": 0.7,
      "doc": "0 is GGX; negative values stretch the highlight across the tangent"
    },
    {
      "name": "anisotropyRotation",
      "title": "Rotation",
      "type": "float",
      "min": 0,
      "max": 360,
      "default": 0,
      "doc": "Degrees by which the tangent turns about the normal, counter-clockwise"
    }
  ],
  "tangentRotation": "anisotropyRotation",
  "terms": {"D": "GGXaniso", "V": "SmithGGXCorrelatedAniso", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Burley 2012, Physically-Based Shading at Disney, appendix B, eq. 13 (D), section 5.4 (aspect)",
    "Heitz 2014, eq. 86 and 99 (V)",
    "Schlick 1994, eq. 15 (F)"
  ]
}
*/
