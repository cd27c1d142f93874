#version 450 core
// How open a pixel is to its surroundings, at half the resolution: the share of the hemisphere, weighted by the cosine, that
// nothing near by in the depth of the picture covers. Horizons in slices through the view ray, whose light between them is
// integrated exactly ("Practical Real-Time Strategies for Accurate Indirect Occlusion", Jimenez and others 2016).
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/screen.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec2 outOcclusion;   // the share, and the depth in metres; 0 where no surface is
uniform float radius;        // metres
uniform ivec2 halfOffset;    // of the pixel that is looked at, among the four of a texel

const int kSlices = 2, kSteps = 8;
const float kPi = 3.14159265;
const float kLift = 0.002;   // cosine: what rises less is the surface itself, rounded

// The light that comes from the side of an angle h up to the view direction, by the cosine to a normal at angle n.
float arc(float h, float n) { return 0.25 * (cos(n) + 2.0 * h * sin(n) - cos(2.0 * h - n)); }

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy), pixel = clamp(texel * 2 + halfOffset, viewRectangle.xy, viewRectangle.zw - 1);
  vec2 at = vec2(pixel) + 0.5;
  float depthValue = texelFetch(gDepth, pixel, 0).r, depth = linearDepth(depthValue);
  vec3 N = normalize(texelFetch(gNormal, pixel, 0).xyz), V = towardsViewer(at);
  // Off the surface, so that the depth's own rounding hides nothing.
  vec3 P = worldAtDepth(at, depth) + N * (0.5 * pixelSize(depth));
  float reach = min(radius / pixelSize(depth), 0.5 * float(viewRectangle.w - viewRectangle.y));
  bool surface = depthValue < 1.0;
  // Sixteen directions over a square of four by four texels, which the blur averages.
  float direction = float((((texel.x + texel.y) & 3) << 2) + (texel.x & 3)) / 16.0 + sampleNumber * 0.6180340;
  float start = fract(float((texel.y - texel.x) & 3) / 4.0 + 0.125 + sampleNumber * 0.7548777);
  vec3 right = view.originX.xyz + view.rayX.xyz, up = view.originY.xyz + view.rayY.xyz;
  float open = 0.0, all = 0.0;
  for (int i = 0, slices = surface && reach > 1.0 ? kSlices : 0; i < slices; ++i) {
    float phi = kPi * (float(i) + fract(direction)) / float(kSlices);
    vec2 omega = vec2(cos(phi), sin(phi));
    vec3 D = normalize(omega.x * right + omega.y * up), across = D - dot(D, V) * V, axis = normalize(cross(D, V));
    vec3 inSlice = N - axis * dot(N, axis);
    float size = max(length(inSlice), 1e-5), n = acos(clamp(dot(inSlice, V) / size, -1.0, 1.0)) * (dot(across, inSlice) < 0.0 ? -1.0 : 1.0);
    // Cosines of the horizons, from those of the surface's own plane on.
    vec2 low = vec2(cos(n + 0.5 * kPi), cos(n - 0.5 * kPi)), horizon = low;
    for (int k = 0; k < kSteps; ++k) {
      float t = (float(k) + start) / float(kSteps);
      vec2 offset = omega * max(t * t * reach, float(k) + 1.3);
      for (int side = 0; side < 2; ++side) {
        ivec2 there = ivec2(floor(side == 0 ? at + offset : at - offset));
        float z = texelFetch(gDepth, clamp(there, viewRectangle.xy, viewRectangle.zw - 1), 0).r;
        vec3 to = worldPosition(vec2(there) + 0.5, z) - P;
        float far = max(length(to), 1e-9), weight = z < 1.0 && inView(there) ? clamp(2.0 - 2.0 * far / radius, 0.0, 1.0) : 0.0;
        float cosine = mix(low[side], dot(to, V) / far - kLift, weight);
        horizon[side] = max(horizon[side], cosine);
      }
    }
    vec2 h = vec2(acos(clamp(horizon.x, -1.0, 1.0)), -acos(clamp(horizon.y, -1.0, 1.0)));
    open += size * (arc(h.x, n) + arc(h.y, n));
    // Of the whole slice: so few of them make the hemisphere only on average.
    all += size * (arc(n + 0.5 * kPi, n) + arc(n - 0.5 * kPi, n));
  }
  outOcclusion = vec2(all > 0.0 ? clamp(open / all, 0.0, 1.0) : 1.0, surface ? depth : 0.0);
}
