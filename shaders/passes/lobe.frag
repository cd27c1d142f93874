#version 450 core
// The lobe of a model seen from the normal, over the angle of the light: what the prefiltered environment averages
// with. x: angle, theta = pi/2 u^2 over the row; y: roughness, and for models that use the tangent the azimuth, from
// the tangent on through half a turn, all roughnesses for each. A model with a D has Karis' kernel D NoL (2013,
// PrefilterEnvMap); one without, its own f NoL, a whole one what is above its floor.
#include "shaders/common/shading.glsl"
#pragma glint model
#include "shaders/common/floor_light.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
uniform float width;
uniform float roughnesses[16];
uniform int roughnessCount, azimuthCount;
uniform bool plainNonmetal;
uniform vec4 standardParameters;

#ifdef COAT
const bool useD = false;
#else
const bool useD = modelHasD;
#endif

void main() {
  float u = gl_FragCoord.x / width;
  float theta = 1.5707963267948966 * u * u;
  Shading s;
  int row = int(gl_FragCoord.y);
  float azimuth = kPi * float(row / roughnessCount) / float(azimuthCount);
  setRoughness(s, roughnesses[row % roughnessCount]);
  s.baseColor = s.F0 = vec3(1.0);
  s.diffuseColor = vec3(0.0);
  s.metallic = 1.0;
  s.specular = 0.5;
  s.analyticLight = false;
  s.plainNonmetal = plainNonmetal;
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
#ifdef MODEL_IS_WHOLE
  // Next to the normal: on it the azimuth of the view, which some divide by, has no value. The angles count from where it
  // is mirrored to, which a narrow lobe is around.
  vec3 V = vec3(0.0, 0.01, 0.99995);
#else
  vec3 V = vec3(0.0, 0.0, 1.0);
#endif
  vec3 R = vec3(-V.xy, V.z), L = sin(theta) * (cos(azimuth) * vec3(1.0, 0.0, 0.0) + sin(azimuth) * vec3(0.0, R.z, -R.y)) + cos(theta) * R;
  setDirections(s, vec3(0.0, 0.0, 1.0), V, L);
  Parameters p = modelParameters(standardParameters);
  modelPrepare(s, p);
  vec3 f = useD ? vec3(modelD(s, p)) : modelLobe(s, p);
#ifdef MODEL_IS_WHOLE
  f -= min(modelFloor(s, p), f);
#endif
  float kernel = dot(f, vec3(1.0 / 3.0)) * max(L.z, 0.0);
  // Less than nothing says that it was not finite.
  outColor = vec4(abs(kernel) < 1e30 ? max(kernel, 0.0) : -1.0);
}
