#version 450 core
#include "shaders/common/view.glsl"
#include "shaders/common/material.glsl"
#include "shaders/common/gbuffer.glsl"
#include "shaders/common/material_inputs.glsl"
layout(location = 0) out vec4 outBaseColor;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outMaterial;
#ifdef WRITES_EMISSIVE
layout(location = 3) out vec4 outEmissive;
#endif
#ifdef WRITES_PARAMETERS
layout(location = 4) out vec4 outParameters;
#endif
#ifdef WRITES_TANGENT
layout(location = 5) out vec4 outTangent;
#endif
uniform float lightGroup;      // / 255
uniform float opacityCutoff;
uniform vec4 standardParameters;
#ifdef SPECULAR_ANTIALIASING
uniform float pixelShare;         // 1 / the pictures averaged
uniform vec4 coatRoughnessSlot;   // 1 in the component of the model's parameters that is the roughness of its coat
#endif

#pragma glint material
#include "shaders/common/shading.glsl"
#include "shaders/common/specular_antialiasing.glsl"

void main() {
  MaterialInputs i = materialInputs();
  i.view = towardsViewer(gl_FragCoord.xy);
  MaterialAttributes m;
  m.model = standardParameters;
  m.normalVariance = 0.0;
  evaluateMaterial(i, m);
#ifdef WRITES_OPACITY_MASK
  if (m.opacityMask < opacityCutoff) discard;
#endif
  vec3 normal = i.normal;
#ifdef WRITES_NORMAL
  normal = normalize(m.normal.x * i.tangent + m.normal.y * i.bitangent + m.normal.z * i.normal);
#endif
#ifdef SPECULAR_ANTIALIASING
  float wider = alpha2OfBend(i.normal, viewRay(gl_FragCoord.xy), pixelShare) + alpha2OfSlopes(m.normalVariance);
  m.roughness = widenedRoughness(m.roughness, wider);
  m.model = mix(m.model, vec4(widenedRoughness(dot(m.model, coatRoughnessSlot), wider)), coatRoughnessSlot);
#endif
  // Half floats end at 65504; metallic, specular and roughness are clamped by their format.
  outBaseColor = vec4(clamp(m.baseColor, 0.0, 65504.0), m.ambientOcclusion);
  outNormal = vec4(normal, clamp(m.cavity, 0.0, 1.0));
  outMaterial = vec4(m.metallic, m.specular, m.roughness, lightGroup);
#ifdef WRITES_EMISSIVE
  outEmissive = vec4(clamp(m.emissive, 0.0, 65000.0), 1.0);
#endif
#ifdef WRITES_PARAMETERS
  outParameters = m.model;
#endif
#ifdef WRITES_TANGENT
  vec3 from = anyTangent(normal);
  outTangent = vec4(atan(dot(i.tangent, cross(normal, from)), dot(i.tangent, from)) / 3.14159265);
#endif
}
