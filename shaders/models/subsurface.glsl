/*glint
{
  "id": "subsurface",
  "title": "Subsurface",
  "doc": "Light goes in and comes out elsewhere, also from behind: ice, wax, leaves, skin from afar.",
  "color": [0.95, 0.55, 0.30],
  "parameters": [
    {"name": "subsurfaceColor", "title": "Subsurface color", "type": "color", "default": [0.9, 0.45, 0.3], "doc": "Of the light that was inside"},
    {"name": "subsurface", "title": "Subsurface", "type": "float", "default": 0.6, "doc": "How much of the light that is not reflected goes in"},
    {
      "name": "translucency",
      "title": "Translucency",
      "type": "float",
      "default": 0.3,
      "doc": "How much of that goes on straight through thin parts: a glow around a light behind them"
    }
  ],
  "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": [
    "Karis 2013, p. 10 (Subsurface)",
    "Green 2004, Real-Time Approximations to Subsurface Scattering, GPU Gems, section 16.2: wrapped lighting, here normalised",
    "Barre-Brisebois and Bouchard 2011, Approximating Translucency for a Fast, Cheap and Convincing Subsurface Scattering Look"
  ]
}
*/

// What goes in is no longer reflected by the surface.
void colors(inout Shading s, Parameters p) { s.diffuseColor *= 1.0 - p.subsurface; }

// Both parts come to 1 over all directions, so that a white surface sends out what it received.
vec3 scattered(Shading s, Parameters p) {
  float wrapped = (1.0 + dot(s.N, s.L)) / (4.0 * kPi);
  const float kNarrowness = 12.0;
  float through = pow(max(-s.LoV, 0.0), kNarrowness) * (kNarrowness + 1.0) / (2.0 * kPi);
  return p.subsurfaceColor * (p.subsurface * (1.0 - s.metallic) * mix(wrapped, through, p.translucency));
}
