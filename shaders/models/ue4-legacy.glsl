/*glint
{
  "id": "ue4-legacy",
  "title": "Unreal 4 (legacy colors)",
  "doc": "The diffuse and the specular color chosen apart, which the notes kept for one game that was not photorealistic: complementary colors, no metallic.",
  "color": [0.80, 0.78, 0.35],
  "parameters": [
    {"name": "specularColor", "title": "Specular color", "type": "color", "default": [0.04, 0.04, 0.04], "doc": "Reflectance at normal incidence"},
    {
      "name": "legacyColors",
      "title": "Legacy colors",
      "type": "bool",
      "default": true,
      "doc": "On, base color is the diffuse color; off, base color, metallic and specular mean what they do elsewhere"
    }
  ],
  "terms": {"D": "GGX", "V": "SchlickGGX", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": true},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": ["Karis 2013, Real Shading in Unreal Engine 4, p. 9 (DiffuseColor and SpecularColor), eq. 3 to 5 with k = alpha / 2"]
}
*/

void colors(inout Shading s, Parameters p) {
  if (!p.legacyColors) return;
  s.diffuseColor = s.baseColor;
  s.F0 = p.specularColor;
}

// Lights with the spherical Gaussian, environments with the power itself, as in the notes' listings.
vec3 F(Shading s, Parameters p) { return s.analyticLight ? F_SphericalGaussian(s) : F_Schlick(s); }
