#version 450 core
// Where no surface is: the environment, sharp or blurred, or one colour.
#include "shaders/common/view.glsl"
#include "shaders/common/output.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 6) uniform samplerCube environment;
uniform vec4 background;   // rgb; a: 1 for the colour, 0 for the environment
uniform float level;

void main() {
  vec3 d = normalize(viewRay(gl_FragCoord.xy));
  vec3 radiance = textureLod(environment, environmentFromWorld(d), level).rgb * view.environmentIntensity;
  outColor = outputColor(mix(radiance, background.rgb, background.a));
}
