#version 450 core
// A jittered picture and the average of those before it, brought to where the surfaces are now: renderer/passes/temporal_pass.h.
// With REMEMBER a sum of pictures becomes such an average.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/screen.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(binding = 16) uniform sampler2D current;
layout(binding = 17) uniform sampler2D history;   // rgb, and metres to the nearest surface about
uniform float share;      // of the current picture, at least
uniform vec2 jitter;      // of the current picture, pixels
#ifdef REMEMBER
layout(location = 0) out vec4 outHistory;
#else
layout(location = 0) out vec4 outColor;
layout(location = 1) out vec4 outHistory;
uniform mat4 pastClipFromWorld;   // without jitter
uniform vec4 pastDepthTerms;      // as view.depthTerms
#endif

const ivec2 kCross[5] = ivec2[5](ivec2(0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
const float kNothing = 60000.0;   // metres, for half floats: no surface

vec3 yCoCg(vec3 c) { return vec3(0.25 * c.r + 0.5 * c.g + 0.25 * c.b, 0.5 * (c.r - c.b), -0.25 * c.r + 0.5 * c.g - 0.25 * c.b); }
vec3 fromYCoCg(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

// Catmull and Rom's cubic as five bilinear reads, without the four corners, which weigh little (Jimenez 2016, "Filmic SMAA"):
// a bilinear history grows softer from frame to frame.
vec3 sharpHistory(vec2 at) {
  vec2 size = vec2(textureSize(history, 0)), center = floor(at - 0.5) + 0.5, f = at - center;
  vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f), w3 = f * f * (-0.5 + 0.5 * f), w12 = 1.0 - w0 - w3;
  vec2 p0 = (center - 1.0) / size, p12 = (center + (w12 - w1) / w12) / size, p3 = (center + 2.0) / size;
  vec4 sum = vec4(textureLod(history, vec2(p12.x, p0.y), 0.0).rgb, 1.0) * (w12.x * w0.y) +
             vec4(textureLod(history, vec2(p0.x, p12.y), 0.0).rgb, 1.0) * (w0.x * w12.y) +
             vec4(textureLod(history, p12, 0.0).rgb, 1.0) * (w12.x * w12.y) +
             vec4(textureLod(history, vec2(p3.x, p12.y), 0.0).rgb, 1.0) * (w3.x * w12.y) +
             vec4(textureLod(history, vec2(p12.x, p3.y), 0.0).rgb, 1.0) * (w12.x * w3.y);
  return sum.rgb / sum.a;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), nearestPixel = pixel;
  float nearest = 1.0;
  vec3 mean = vec3(0.0), square = vec3(0.0), least = vec3(1e6), most = vec3(-1e6);
  for (int i = 0; i < 5; ++i) {
    ivec2 near = clamp(pixel + kCross[i], viewRectangle.xy, viewRectangle.zw - 1);
    float depth = texelFetch(gDepth, near, 0).r;
    if (depth < nearest) {
      nearest = depth;
      nearestPixel = near;
    }
#ifndef REMEMBER
    vec3 c = yCoCg(texelFetch(current, near, 0).rgb);
    mean += c / 5.0;
    square += c * c / 5.0;
    least = min(least, c);
    most = max(most, c);
#endif
  }
  bool surface = nearest < 1.0;
  float metres = surface ? min(linearDepth(nearest), kNothing) : kNothing;
  vec4 now = texelFetch(current, pixel, 0);
#ifdef REMEMBER
  outHistory = vec4(now.rgb * share, metres);
#else
  // An edge moves with what is in front.
  vec2 from = gl_FragCoord.xy, rectangle = vec2(viewRectangle.zw - viewRectangle.xy);
  float expected = kNothing;
  bool known = share < 1.0, orthographic = dot(view.originX.xyz, view.originX.xyz) > 0.0;
  if (surface || !orthographic) {
    vec2 there = vec2(nearestPixel) + 0.5;
    vec4 clip = pastClipFromWorld * (surface ? vec4(worldPosition(there, nearest), 1.0) : vec4(viewRay(there), 0.0));
    known = known && clip.w > 0.0;
    vec3 past = clip.xyz / max(clip.w, 1e-12);
    from += vec2(viewRectangle.xy) + (past.xy * 0.5 + 0.5) * rectangle - there - jitter;
    float depth = past.z * 0.5 + 0.5;
    if (surface) expected = min((pastDepthTerms.x + pastDepthTerms.y * depth) / (pastDepthTerms.z + pastDepthTerms.w * depth), kNothing);
  }
  known = known && inView(ivec2(floor(from)));
  // What came into sight, or went behind something, was not seen there.
  float before = texelFetch(history, clamp(ivec2(floor(from)), ivec2(0), textureSize(history, 0) - 1), 0).a;
  known = known && abs(before - expected) < 0.05 * expected;
  // Far jumps leave little that is the same, and nobody sees their edges.
  float newest = max(share, length(from - gl_FragCoord.xy) / (0.15 * rectangle.y));
  known = known && newest < 1.0;
  vec3 result = now.rgb;
  if (known) {
    // What is unlike anything here now is brought to the nearest that is like it (Salvi 2016, "An Excursion in Temporal
    // Supersampling").
    vec3 reach = 1.25 * sqrt(max(square - mean * mean, 0.0));
    vec3 seen = clamp(yCoCg(sharpHistory(from)), max(mean - reach, least), min(mean + reach, most));
    result = max(mix(fromYCoCg(seen), now.rgb, newest), 0.0);
  }
  outColor = vec4(result, now.a > 0.999 ? 1.0 : 0.0);
  outHistory = vec4(result, metres);
#endif
}
