/*glint
{
  "id": "sheen",
  "title": "Sheen (cloth)",
  "doc": "GGX under a layer of upright fibres, which light up where light or view graze: velvet, dust, fuzz.",
  "color": [0.80, 0.45, 0.66],
  "parameters": [
    {"name": "sheenColor", "title": "Sheen color", "type": "color", "default": [0.5, 0.5, 0.5], "doc": "Of the fibres; black has none"},
    {
      "name": "sheenRoughness",
      "title": "Sheen roughness",
      "type": "float",
      "min": 0.1,
      "max": 1,
      "default": 0.4,
      "doc": "How far the glow reaches from the outline inwards"
    }
  ],
  "coat": {"roughness": "sheenRoughness", "strength": "sheenColor"},
  "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": false},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Estevez and Kulla 2017, Production Friendly Microfacet Sheen BRDF, eq. 2 (D) and 3 (V)",
    "Walter et al. 2007, eq. 33 and Heitz 2014, eq. 99, for the surface below"
  ]
}
*/

// The fibres have a width of their own and take nothing from the surface below.
vec3 coat(Shading s, Parameters p) { return vec3(D_Charlie(s) * V_CharlieFit(s)); }
