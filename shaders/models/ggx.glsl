/*glint
{
  "id": "ggx",
  "title": "GGX (default lit)",
  "doc": "Unreal 5's default: a long, soft tail, and no root, power or exponential to pay for.",
  "color": [0.30, 0.62, 0.88],
  "terms": {"D": "GGX", "V": "SmithGGXCorrelatedApprox", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 33 (D)",
    "Heitz 2014, Understanding the Masking-Shadowing Function, eq. 99, without its roots as Unreal has it (V)",
    "Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering, eq. 15 (F)",
    "Herman's thesis, section 4.1"
  ]
}
*/

// Nothing more is needed: a model whose terms all ship is its head. `glint models` lists the terms' names.
