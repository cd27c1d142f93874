/*glint
{
  "id": "burley",
  "title": "Burley (GTR)",
  "doc": "Generalised Trowbridge-Reitz: gamma sets how long the highlight's tail is. Its G belongs to gamma 2, so with a longer tail it reflects more than it receives at grazing angles, up to 2.3 times: it claims no energy conservation.",
  "color": [0.45, 0.72, 0.48],
  "parameters": [
    {
      "name": "gamma",
      "title": "Tail (gamma)",
      "type": "float",
      "min": 1,
      "max": 4,
      "default": 1.5,
      "doc": "1 has the longest tail, 2 is GGX, larger ones cut it short"
    }
  ],
  "prepared": ["peak"],
  "terms": {"V": "SmithGGX", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": false},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Burley 2012, Physically-Based Shading at Disney, appendix B, eq. 4 (D)",
    "Smith 1967 for GGX, Walter et al. 2007, eq. 34 (V)",
    "Schlick 1994, eq. 15 (F)",
    "Herman's thesis, section 4.4, with gamma 1.5"
  ]
}
*/

// No term's name stands for a D with arguments of its own, so this model writes the function itself and hands its
// parameter over. What it does not write comes from "terms".
float D(Shading s, Parameters p) { return D_GTR(s, p.gamma, p.peak); }

// Called once a pixel, before the lights, when the view and the roughness are known: fills the members that the
// head calls "prepared". A model that has nothing to prepare leaves both out.
void prepare(Shading s, inout Parameters p) { p.peak = peakGTR(s.alpha2, p.gamma); }
