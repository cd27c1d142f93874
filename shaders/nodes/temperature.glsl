/*glint
{
  "id": "temperature",
  "title": "Color temperature",
  "category": "Color",
  "doc": "The colour of a black body, its luminance 1",
  "inputs": [
    {"name": "kelvin", "type": "float", "default": 6500, "min": 1000, "max": 20000}
  ],
  "outputs": [
    {"name": "value", "type": "color"}
  ],
  "keywords": ["blackbody", "kelvin", "emissive"]
}
*/
// Krystek 1985, "An algorithm to calculate correlated colour temperature", eqs. 5 and 6: u, v of the Planckian
// locus, within 8e-5 and 9e-5 from 1000 K to 15000 K. Then xy, XYZ with Y = 1, and linear Rec.709 (D65).
vec3 node_temperature(float kelvin) {
  float t = clamp(kelvin, 1000.0, 15000.0);
  float u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
            (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  float v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
            (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  vec2 xy = vec2(3.0 * u, 2.0 * v) / (2.0 * u - 8.0 * v + 4.0);
  vec3 XYZ = vec3(xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y);
  mat3 rgbFromXyz = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314,
                         0.0415560, 1.0572252);
  return max(rgbFromXyz * XYZ, vec3(0.0));
}
