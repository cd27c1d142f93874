#version 450 core
// Where no surface is.
#include "shaders/common/view.glsl"
#include "shaders/common/output.glsl"
#include "shaders/common/backdrop.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;

void main() { outColor = outputColor(backgroundRadiance(gl_FragCoord.xy)); }
