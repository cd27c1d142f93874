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
  "terms": {"diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": false},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Estevez and Kulla 2017, Production Friendly Microfacet Sheen BRDF, eq. 2 (D) and 3 (V)",
    "Walter et al. 2007, eq. 33 and Heitz 2014, eq. 99, for the surface below"
  ]
}
*/

vec3 specular(Shading s, Parameters p) {
  vec3 below = (D_GGX(s) * V_SmithGGXCorrelated(s)) * F_Schlick(s);
  // The fibres have a width of their own.
  setRoughness(s, p.sheenRoughness);
  return below + p.sheenColor * (D_Charlie(s) * V_CharlieFit(s));
}
