#version 450 core
// A surface in a light's map whose material says where it has holes.
#include "shaders/common/view.glsl"
#include "shaders/common/material.glsl"
#include "shaders/common/material_inputs.glsl"
uniform float opacityCutoff;
uniform vec4 standardParameters;

#pragma glint material

void main() {
  MaterialAttributes m;
  m.model = standardParameters;
  evaluateMaterial(materialInputs(), m);
  if (m.opacityMask < opacityCutoff) discard;
}
