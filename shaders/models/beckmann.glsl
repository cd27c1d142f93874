/*glint
{
  "id": "beckmann",
  "title": "Beckmann-Smith",
  "doc": "Beckmann's distribution with the shadowing that belongs to it: what Cook and Torrance's model is measured against.",
  "color": [0.93, 0.62, 0.45],
  "terms": {"D": "Beckmann", "V": "SmithBeckmann", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 25 (D), eq. 27 (V)",
    "Schlick 1994, eq. 15 (F)"
  ]
}
*/
