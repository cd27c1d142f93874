/*glint
{
  "id": "mobile",
  "title": "Unreal 4 mobile",
  "doc": "As Unreal lights on phones: no table and no D, a fit for the environment and a Gaussian about the reflected view for lights. Not reciprocal, and four times too bright under lights unless told otherwise.",
  "color": [0.56, 0.66, 0.30],
  "parameters": [
    {
      "name": "fullyRough",
      "title": "Fully rough",
      "type": "bool",
      "default": false,
      "doc": "No specular part: 0.45 of its color goes to the diffuse part instead"
    },
    {
      "name": "quarter",
      "title": "Missing 1/4",
      "type": "bool",
      "default": false,
      "doc": "Scales the highlight of lights by the 1/4 that the published form leaves out"
    }
  ],
  "terms": {"diffuse": "Lambert"},
  "claims": {"reciprocal": false, "energyConserving": false},
  "uses": ["baseColor", "metallic", "specular", "roughness"],
  "cite": ["Karis 2014, Physically Based Shading on Mobile: EnvBRDFApprox, EnvBRDFApproxNonmetal, PhongApprox"]
}
*/

// F0 = 0.04 is taken for granted where the material says nothing of metal: fewer operations, nearly the same.
vec3 environment(Shading s, Parameters p) {
  if (p.fullyRough) return vec3(0.0);
  if (s.plainNonmetal) return vec3(envBrdfApproxNonmetal(s.roughness, s.NoV));
  vec2 scaleAndBias = envBrdfApprox(s.roughness, s.NoV);
  // The bias goes below 0 by 0.0024.
  return max(s.F0 * scaleAndBias.x + scaleAndBias.y, 0.0);
}

vec3 specular(Shading s, Parameters p) {
  float RoL = 2.0 * s.NoL * s.NoV - s.LoV;
  return environment(s, p) * (approximateD(s.alpha2, RoL) * (p.quarter ? 0.25 : 1.0) / kPi);
}

void colors(inout Shading s, Parameters p) {
  if (!p.fullyRough) return;
  s.diffuseColor += 0.45 * s.F0;
  s.F0 = vec3(0.0);
}
