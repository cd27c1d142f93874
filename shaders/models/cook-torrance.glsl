/*glint
{
  "id": "cook-torrance",
  "title": "Cook-Torrance",
  "doc": "Beckmann's distribution shadowed by V-shaped cavities: the brightest of the four at grazing angles.",
  "color": [0.85, 0.42, 0.36],
  "terms": {"D": "Beckmann", "G": "CookTorrance", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Beckmann and Spizzichino 1963, The Scattering of Electromagnetic Waves from Rough Surfaces (D)",
    "Cook and Torrance 1982, A Reflectance Model for Computer Graphics (G)",
    "Schlick 1994, eq. 15 (F)",
    "Herman's thesis, section 4.3"
  ]
}
*/
