/*glint
{
  "id": "ue4-2014",
  "title": "Unreal 4 (2014)",
  "doc": "As released: the geometry term is the same for lights and environments, without the notes' remapping, and Specular sets F0.",
  "color": [0.72, 0.60, 0.35],
  "terms": {"D": "GGX", "V": "SchlickGGX", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": ["Karis 2013, Real Shading in Unreal Engine 4, eq. 3 (D), p. 3 with k = alpha / 2 (V), eq. 5 (F)"]
}
*/

// Lights with the spherical Gaussian, environments with the power itself, as in the notes' listings.
vec3 F(Shading s, Parameters p) { return s.analyticLight ? F_SphericalGaussian(s) : F_Schlick(s); }
