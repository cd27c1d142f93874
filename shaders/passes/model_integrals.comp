#version 450 core
// Integrals of a model over the hemisphere, one sum around the normal for each query and each polar node; the nodes'
// weights are the host's (renderer/model_integrals.cpp).
#include "shaders/common/shading.glsl"
#pragma glint model
layout(local_size_x = 64) in;

// values: roughness, NoV, 1 under a light and 0 under an environment, azimuth against the tangent; F0.w: how much wider
// the lobe is along the bitangent; diffuse.w: 0 without authored attributes, 2 for those of a plain nonmetal.
struct Query { vec4 values, slots, F0, diffuse, baseColorMetallic, authoredSpecular; };
// f NoL for the query's F0 and for 0, for facets that reflect all, and of its diffuse; integrals of D in w; scattered over
// all directions.
struct Sums { vec4 specular, specularBlack, white, diffuse, scattered; };
layout(std430, binding = 0) readonly buffer Queries { Query queries[]; };
// Polar nodes u from 0 to 1; sin and cos of the theta_h that stands at u for D; cosine of the light at sin^2 = u.
layout(std430, binding = 1) readonly buffer PolarNodes { vec4 polar[]; };
// cos and sin of an azimuth, and its weight: they add up to 1.
layout(std430, binding = 3) readonly buffer AroundNodes { vec4 around[]; };
layout(std430, binding = 2) writeonly buffer Results { Sums results[]; };
uniform int count;

// As renderer/model_integrals.cpp: theta = kSmallest (e^(k u) - 1).
const float kSmallest = 2e-4;

void colors(inout Shading s, vec3 F0, vec3 diffuse) {
  s.F0 = F0;
  s.diffuseColor = diffuse;
}

// cos and sin of a node's azimuth against the view's, and its weight: the circle of the nodes is stretched as the lobe is,
// so that they are as dense for every lobe.
vec3 aroundAt(vec4 node, mat2 stretch) {
#ifdef MODEL_TANGENT
  vec2 to = stretch * node.xy;
  float length2 = dot(to, to);
  return vec3(to * inversesqrt(length2), node.z * determinant(stretch) / length2);
#else
  return node.xyz;
#endif
}

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= count) return;
  Query query = queries[index / polar.length()];
  vec4 node = polar[index % polar.length()];
  float NoV = query.values.y;
  vec3 V = vec3(sqrt(max((1.0 - NoV) * (1.0 + NoV), 0.0)), 0.0, NoV);

  Shading s;
  setRoughness(s, query.values.x);
  setView(s, vec3(0.0, 0.0, 1.0), V);
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  mat2 stretch = mat2(1.0);
#ifdef MODEL_TANGENT
  turnTangent(s, -query.values.w);
  // From the nodes to the lobe's own circle, of which what was across the view's plane stays so, stretched along the
  // bitangent, and back to the view's plane.
  float cosView = s.T.x, sinView = -s.T.y, aspect = query.F0.w;
  vec2 across = normalize(vec2(-sinView, cosView / aspect));
  stretch = mat2(cosView, -sinView, sinView, cosView) * mat2(1.0, 0.0, 0.0, aspect) * mat2(across.y, -across.x, across.x, across.y);
#endif
  bool authored = query.diffuse.w != 0.0;
  s.baseColor = authored ? query.baseColorMetallic.rgb : vec3(1.0);
  s.specular = authored ? query.authoredSpecular.x : 0.5;
  s.metallic = authored ? query.baseColorMetallic.w : 1.0;
  colors(s, query.F0.rgb, vec3(1.0));
  s.analyticLight = query.values.z != 0.0;
  s.plainNonmetal = query.diffuse.w == 2.0;
  Parameters p = modelParameters(query.slots);
  modelPrepare(s, p);

  Sums sums = Sums(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  for (int j = 0; j < around.length(); ++j) {
    vec3 azimuth = aroundAt(around[j], stretch);
    // The half vectors whose light is above the horizon end where cos(2 theta - delta) = 0: nodes over just these meet
    // no edge.
    float delta = atan(V.x * azimuth.x, NoV);
    float end = 0.25 * kPi + 0.5 * delta;
    float k = log(1.0 + end / kSmallest), grown = kSmallest * exp(k * node.x);
    float theta = grown - kSmallest, sinTheta = sin(theta), cosTheta = cos(theta);
    vec3 H = vec3(sinTheta * azimuth.x, sinTheta * azimuth.y, cosTheta);
    float VoH = dot(V, H);
    vec3 L = 2.0 * VoH * H - V;
    if (VoH <= 0.0 || L.z <= 0.0) continue;
    setLight(s, L);
    // From the half vector itself: going through L loses its last digits.
    s.H = H;
    s.NoH = cosTheta;
    s.sinH2 = sinTheta * sinTheta;
    float weight = azimuth.z * sinTheta * grown * k * 4.0 * VoH * L.z;
    colors(s, query.F0.rgb, vec3(1.0));
    sums.specular.rgb += modelSingleBounce(s, p) * weight;
    colors(s, vec3(1.0), vec3(1.0));
    sums.white.rgb += modelWhite(s, p) * weight;
    colors(s, vec3(0.0), vec3(1.0));
    sums.specularBlack.rgb += modelSingleBounce(s, p) * weight;
  }
#ifdef COMPENSATE
  // Of smooth surfaces all at the horizon: nodes of its own. The same all around where nothing reads the tangent.
  float decades = log(1.0 + 1e4), grazing = 1e-4 * exp(decades * node.x), NoL = grazing - 1e-4;
#ifdef MODEL_TANGENT
  for (int j = 0; j < around.length(); ++j) {
    vec3 azimuth = around[j].xyz;
#else
  {
    vec3 azimuth = vec3(1.0, 0.0, 1.0);
#endif
    float weight = azimuth.z * NoL * grazing * decades;
    setLight(s, vec3(sqrt((1.0 - NoL) * (1.0 + NoL)) * azimuth.xy, NoL));
    colors(s, query.F0.rgb, vec3(1.0));
    sums.specular.rgb += glintFurtherBounces(s, p.glintBounces) * weight;
    colors(s, vec3(0.0), vec3(1.0));
    sums.specularBlack.rgb += glintFurtherBounces(s, p.glintBounces) * weight;
  }
#endif
#ifndef SPECULAR_ONLY
  for (int j = 0; j < around.length(); ++j) {
    vec3 azimuth = aroundAt(around[j], stretch);
    vec3 H = vec3(node.y * azimuth.x, node.y * azimuth.y, node.z);
    float VoH = dot(V, H);
    setLight(s, 2.0 * VoH * H - V);
    s.H = H;
    s.NoH = node.z;
    s.sinH2 = node.y * node.y;
    float D = modelD(s, p) * azimuth.z;
    sums.specular.w += D * node.z;
    sums.specularBlack.w += D * max(VoH, 0.0);
  }
  if (!authored) s.metallic = 0.0;
  colors(s, vec3(0.04), query.diffuse.rgb);
  for (int j = 0; j < around.length(); ++j) {
    vec4 azimuth = around[j];
    setLight(s, vec3(sqrt(node.x) * azimuth.x, sqrt(node.x) * azimuth.y, node.w));
    sums.diffuse.rgb += modelDiffuse(s, p) * azimuth.z;
    if (modelScatters) {
      float z = 2.0 * node.x - 1.0, r = sqrt(max(1.0 - z * z, 0.0));
      setLight(s, vec3(r * azimuth.x, r * azimuth.y, z));
      sums.scattered.rgb += modelScattered(s, p) * azimuth.z;
    }
  }
#endif
  results[index] = sums;
}
