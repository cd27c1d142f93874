#version 450 core
// How far an approximation is from its reference, in colours (renderer/reference_error.h).
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 0) uniform sampler2D approximation;
layout(binding = 1) uniform sampler2D firstReference;
layout(binding = 2) uniform sampler2D secondReference;
uniform float scale;       // 1 / frames
uniform float errorScale, errorFloor;
uniform vec3 less, none, more, noSurface;

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 a = texelFetch(approximation, pixel, 0) * scale;
  vec4 r = (texelFetch(firstReference, pixel, 0) + texelFetch(secondReference, pixel, 0)) * (0.5 * scale);
  // What lies behind surfaces is far below nothing.
  bool surface = a.a > 0.0 && min(luminance(a.rgb), luminance(r.rgb)) > -1.0;
  float reference = luminance(r.rgb);
  float share = clamp((luminance(a.rgb) - reference) / (max(reference, errorFloor) * errorScale), -1.0, 1.0);
  vec3 color = mix(none, share < 0.0 ? less : more, abs(share));
  outColor = vec4(surface ? color : noSurface, min(a.a, r.a) > 0.999 ? 1.0 : 0.0);
}
