#version 450 core
// The average of the samples, into the picture. With TONEMAP they are radiance, else what a display shows already.
#ifdef TONEMAP
#include "shaders/common/tonemap.glsl"
#else
vec3 displayed(vec3 c) { return max(c, 0.0); }
#endif
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 0) uniform sampler2D accumulated;
uniform float scale;       // 1 / samples

void main() {
  vec4 sum = texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0) * scale;
  outColor = vec4(displayed(sum.rgb), sum.a > 0.999 ? 1.0 : 0.0);
}
