#version 450 core
// Integrals of a model over the hemisphere, one sum around the normal for each query and each polar node; the nodes'
// weights are the host's (renderer/model_integrals.cpp).
#include "shaders/common/shading.glsl"
#pragma glint model
layout(local_size_x = 64) in;

struct Query { vec4 roughnessNoVLight, slots; };  // roughness, NoV, 1 under a light and 0 under an environment
struct Sums { vec4 specularWhite, specularBlack, diffuse; };  // f NoL for F0 1 and 0, and for diffuseColor 1; D in w
layout(std430, binding = 0) readonly buffer Queries { Query queries[]; };
layout(std430, binding = 1) readonly buffer Nodes { vec4 nodes[]; };  // sin, cos of theta_h; sin, cos of theta_l
layout(std430, binding = 2) writeonly buffer Results { Sums results[]; };
uniform int count;

const int kAround = 96, kAroundDiffuse = 48;

void colors(inout Shading s, float F0, float diffuse) {
  s.F0 = vec3(F0);
  s.diffuseColor = vec3(diffuse);
}

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= count) return;
  Query query = queries[index / nodes.length()];
  vec4 node = nodes[index % nodes.length()];
  float NoV = query.roughnessNoVLight.y;
  vec3 V = vec3(sqrt(max((1.0 - NoV) * (1.0 + NoV), 0.0)), 0.0, NoV);

  Shading s;
  setRoughness(s, query.roughnessNoVLight.x);
  setView(s, vec3(0.0, 0.0, 1.0), V);
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  s.baseColor = vec3(1.0);
  s.specular = 0.5;
  s.metallic = 1.0;
  colors(s, 1.0, 1.0);
  s.analyticLight = query.roughnessNoVLight.z != 0.0;
  Parameters p = modelParameters(query.slots);
  modelPrepare(s, p);

  Sums sums = Sums(vec4(0.0), vec4(0.0), vec4(0.0));
  for (int j = 0; j < kAround; ++j) {
    float phi = (float(j) + 0.5) * (2.0 * kPi / float(kAround));
    vec3 H = vec3(node.x * cos(phi), node.x * sin(phi), node.y);
    float VoH = dot(V, H);
    vec3 L = 2.0 * VoH * H - V;
    setLight(s, L);
    // From the half vector itself: going through L loses its last digits.
    s.H = H;
    s.NoH = node.y;
    s.sinH2 = node.x * node.x;
    float D = modelD(s, p);
    sums.specularWhite.w += D * node.y;
    sums.specularBlack.w += D * max(VoH, 0.0);
    if (VoH <= 0.0 || L.z <= 0.0) continue;
    float weight = 4.0 * VoH * L.z;
    colors(s, 1.0, 1.0);
    sums.specularWhite.rgb += modelSpecular(s, p) * weight;
    colors(s, 0.0, 1.0);
    sums.specularBlack.rgb += modelSpecular(s, p) * weight;
  }
  s.metallic = 0.0;
  colors(s, 0.04, 1.0);
  for (int j = 0; j < kAroundDiffuse; ++j) {
    float phi = (float(j) + 0.5) * (2.0 * kPi / float(kAroundDiffuse));
    setLight(s, vec3(node.z * cos(phi), node.z * sin(phi), node.w));
    sums.diffuse.rgb += modelDiffuse(s, p);
  }
  sums.specularWhite /= float(kAround);
  sums.specularBlack /= float(kAround);
  sums.diffuse /= float(kAroundDiffuse);
  results[index] = sums;
}
