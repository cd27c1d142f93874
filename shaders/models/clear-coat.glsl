/*glint
{
  "id": "clear-coat",
  "title": "Clear coat",
  "doc": "GGX under a thin layer of lacquer with a highlight of its own: car paint, varnished wood, carbon fibre.",
  "color": [0.90, 0.36, 0.52],
  "parameters": [
    {"name": "clearCoat", "title": "Clear coat", "type": "float", "default": 1, "doc": "How much of the surface it covers"},
    {
      "name": "clearCoatRoughness",
      "title": "Coat roughness",
      "type": "float",
      "default": 0.1,
      "doc": "Of the lacquer; the surface below keeps its own"
    }
  ],
  "coat": {"roughness": "clearCoatRoughness", "strength": "clearCoat"},
  "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Karis 2013, p. 10: a second layer with its own highlight, which doubles the environment's samples",
    "Walter et al. 2007, eq. 33 (D); Heitz 2014, eq. 99 (V, below); Kelemen and Szirmay-Kalos 2001 (V of the coat)",
    "Schlick 1994, eq. 15, with F0 = 0.04 for an index of refraction of 1.5 (F of the coat)"
  ]
}
*/

const float kLacquer = 0.04;

float lacquerFresnel(float cosine) { return kLacquer + (1.0 - kLacquer) * schlickWeight(cosine); }

vec3 coat(Shading s, Parameters p) { return vec3(D_GGX(s) * V_Kelemen(s) * lacquerFresnel(s.VoH)); }

// What enters through the lacquer towards the surface and leaves it again towards the viewer.
vec3 throughCoat(Shading s, Parameters p) {
  return vec3((1.0 - p.clearCoat * lacquerFresnel(s.NoL)) * (1.0 - p.clearCoat * lacquerFresnel(s.NoV)));
}
