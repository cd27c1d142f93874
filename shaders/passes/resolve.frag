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
#ifdef FOLLOWING
layout(binding = 1) uniform sampler2D before;   // renderer/passes/temporal_pass.h: the same view, as it was shown last
uniform float share;                            // of the samples
#endif

void main() {
  vec4 sum = texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0) * scale;
#ifdef FOLLOWING
  sum.rgb = mix(texelFetch(before, ivec2(gl_FragCoord.xy), 0).rgb, sum.rgb, share);
#endif
  outColor = vec4(displayed(sum.rgb), sum.a > 0.999 ? 1.0 : 0.0);
}
