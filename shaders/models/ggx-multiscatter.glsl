/*glint
{
  "id": "ggx-multiscatter",
  "title": "GGX, all bounces",
  "doc": "GGX that loses no light to bounces among its facets: a white rough metal stays white, a coloured one deepens.",
  "color": [0.36, 0.55, 0.95],
  "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "compensate": true,
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Walter et al. 2007, eq. 33 (D)",
    "Heitz 2014, eq. 99 (V)",
    "Schlick 1994, eq. 15 (F)",
    "Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks (further bounces)"
  ]
}
*/

// "compensate" is all it takes: Glint measures what a single bounce loses, and gives it back.
