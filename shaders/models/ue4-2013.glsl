/*glint
{
  "id": "ue4-2013",
  "title": "Unreal 4 (2013)",
  "doc": "As in the course notes: the geometry term softened for lights only, against hot highlights on smooth surfaces.",
  "color": [0.62, 0.50, 0.83],
  "terms": {"D": "GGX", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": ["Karis 2013, Real Shading in Unreal Engine 4, eq. 3 (D), eq. 4 (V), eq. 5 (F)"]
}
*/

// k = (roughness + 1)^2 / 8 for lights; under an environment it would be far too dark at grazing angles, and
// k = alpha / 2 is meant.
float V(Shading s, Parameters p) { return s.analyticLight ? V_SchlickGGXHot(s) : V_SchlickGGX(s); }

// The notes light with the spherical Gaussian and integrate their environment table with the power itself.
vec3 F(Shading s, Parameters p) { return s.analyticLight ? F_SphericalGaussian(s) : F_Schlick(s); }
