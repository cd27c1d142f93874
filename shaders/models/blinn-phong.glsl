/*glint
{
  "id": "blinn-phong",
  "title": "Blinn-Phong",
  "doc": "A tight highlight without a tail, normalised; the darkest of the four on rough surfaces.",
  "color": [0.93, 0.70, 0.30],
  "terms": {"D": "Blinn", "V": "SchlickBeckmann", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures (D)",
    "Walter et al. 2007, sec. 5.2: the exponent 2 / alpha^2 - 2",
    "Schlick 1994, eq. 19, with k = alpha sqrt(2 / pi) (V), and eq. 15 (F)",
    "Herman's thesis, section 4.2"
  ]
}
*/
