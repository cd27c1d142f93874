#version 450 core
// A model's D at given half vectors and roughnesses; light and view are the half vector too.
#include "shaders/common/shading.glsl"
#pragma glint model
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer HalfVectors { vec4 halfVectors[]; };  // about +Z; w: sin^2 to it
layout(std430, binding = 1) readonly buffer Roughnesses { float roughnesses[]; };
layout(std430, binding = 2) writeonly buffer Values { float values[]; };           // by roughness, then half vector
uniform vec4 standardParameters;

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= roughnesses.length() * halfVectors.length()) return;
  vec4 h = halfVectors[index % halfVectors.length()];
  Shading s;
  setRoughness(s, roughnesses[index / halfVectors.length()]);
  s.baseColor = s.F0 = vec3(1.0);
  s.diffuseColor = vec3(0.0);
  s.metallic = 1.0;
  s.specular = 0.5;
  s.analyticLight = true;
  s.plainNonmetal = false;
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  setDirections(s, vec3(0.0, 0.0, 1.0), h.xyz, h.xyz);
  s.H = h.xyz;
  s.NoH = h.z;
  s.sinH2 = h.w;
  Parameters p = modelParameters(standardParameters);
  modelPrepare(s, p);
  float D = modelD(s, p);
  values[index] = D > 0.0 && D < 1e30 ? D : 0.0;
}
