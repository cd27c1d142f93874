/*glint
{
  "id": "gtr-smith",
  "title": "GTR with its own Smith term",
  "doc": "Generalised Trowbridge-Reitz with the masking that its own facets have, integrated from D by Glint: the tail of any gamma, and no energy gained by it.",
  "color": [0.35, 0.68, 0.62],
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
  "terms": {"V": "SmithCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Burley 2012, Physically-Based Shading at Disney, appendix B, eq. 4 (D)",
    "Smith 1967, Heitz 2014, Understanding the Masking-Shadowing Function, eq. 14 and 99, for this D (V)",
    "Schlick 1994, eq. 15 (F)"
  ]
}
*/

float D(Shading s, Parameters p) { return D_GTR(s, p.gamma, p.peak); }

void prepare(Shading s, inout Parameters p) { p.peak = peakGTR(s.alpha2, p.gamma); }
