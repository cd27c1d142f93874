#version 450 core
// One buffer of the G-buffer as a picture; renderer/view_modes.cpp has the list, in this order.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
uniform int mode;
uniform vec4 groupColors[256];  // by light group, linear

// Data shows on the screen as its number: undoes the encoding of the target. A linear picture has none.
vec3 shown(vec3 x) {
#ifdef SCENE_REFERRED
  return x;
#endif
  x = clamp(x, 0.0, 1.0);
  return mix(x / 12.92, pow((x + 0.055) / 1.055, vec3(2.4)), greaterThan(x, vec3(0.04045)));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Surface s = readSurface(pixel);
  vec3 c = s.baseColor;
  if (mode == 1) c = shown(s.normal * 0.5 + 0.5);
  if (mode == 2) c = shown(vec3(s.metallic));
  if (mode == 3) c = shown(vec3(s.specular));
  if (mode == 4) c = shown(vec3(s.roughness));
  if (mode == 5) c = shown(vec3(s.cavity));
  if (mode == 6) c = shown(vec3(s.ambientOcclusion));
#ifdef EMISSIVE
  if (mode == 7) c = texelFetch(gEmissive, pixel, 0).rgb;
#else
  if (mode == 7) c = vec3(0.0);
#endif
  if (mode == 8) c = groupColors[int(s.group + 0.5)].rgb;
#ifdef READS_PARAMETERS
  if (mode == 9) c = shown(texelFetch(gParameters, pixel, 0).rgb);
#else
  if (mode == 9) c = vec3(0.0);
#endif
  if (mode == 10) c = shown(vec3(1.0 - 0.9 * texelFetch(gDepth, pixel, 0).r));
  if (mode == 11) {
    ivec4 placed = ivec4(inLights.zw & 0xffff, inLights.zw >> 16);
    int lights = inLights.y + placed.x + placed.y + placed.z + placed.w;
    float load = min(float(lights) / 64.0, 1.0);
    c = lights == 0 ? vec3(0.0) : mix(vec3(0.0, 0.08, 0.4), vec3(1.0, 0.35, 0.0), load);
  }
#ifndef SCENE_REFERRED
  c = clamp(c, 0.0, 1.0);
#endif
  outColor = vec4(c, 1.0);
}
