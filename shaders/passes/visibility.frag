#version 450 core
// How much of one light arrives at each pixel: its shadow map, with edges as soft as the light is large (percentage-closer
// soft shadows, Fernando 2005), and with CONTACT a short way through the picture's own depth.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/screen.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out float outVisibility;
layout(binding = 16) uniform sampler2D shadowMap;
layout(binding = 17) uniform sampler2DShadow shadowTest;
// Of renderer/light_shadow.h.
uniform mat4 mapFromWorld, worldFromMap;
uniform vec4 source, towards;
uniform vec2 texel;          // side of one: metres (with towards.w = 1 for each metre of distance), and share of the map
uniform float sine;
uniform float contactLength; // metres

const int kSearched = 12, kFiltered = 16, kContactSteps = 12;
const float kWidest = 0.4;       // of the map: a penumbra's half width, so that so few samples can make it
const float kEmpty = 0.999999;    // a map's depth where nothing is
const float kSteepest = 0.16;     // cosine to the light down to which a receiving plane is followed
const float kTilt = 0.14;         // slope below which what rises from it casts no shadow on it

// Vogel's spiral: points of a disc, each turned by the golden angle from the one before.
const mat2 kGolden = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

float mapVisibility(vec3 P, vec3 plane, vec3 L, float distance, vec2 noise) {
  // Not steeper than can be followed.
  plane = normalize(plane + L * max(kSteepest - dot(plane, L), 0.0));
  float cosine = dot(plane, L), slope = sqrt(max(1.0 - cosine * cosine, 0.0));
  // Off the surface, by as much as its depth changes over the texels that one test reads.
  float side = texel.x * (towards.w > 0.0 ? distance : 1.0);
  vec3 X = P + plane * (side * (0.4 + 1.6 * slope));
  vec4 q = mapFromWorld * vec4(X, 1.0);
  if (q.w <= 0.0) return 1.0;
  vec3 m = q.xyz / q.w;
  // The receiving plane in the map: a wide filter must not meet the surface itself.
  vec4 inMap = vec4(plane, -dot(plane, X)) * worldFromMap;
  vec2 gradient = abs(inMap.z) > 1e-12 ? -inMap.xy / inMap.z : vec2(0.0);
  // And not its neighbours either, which a mesh tilts a little against it: a cone, not a plane.
  vec4 nearer = mapFromWorld * vec4(X + L * side, 1.0);
  float tilt = kTilt * abs(m.z - nearer.z / max(nearer.w, 1e-9)) / texel.y;

  vec2 u = source.xy * max(m.z, 0.0), v = source.zw * max(m.z, 0.0);
  float widest = max(length(u), length(v));
  float shrink = min(1.0, kWidest / max(widest, 1e-9));
  u *= shrink;
  v *= shrink;
  vec2 start = vec2(cos(6.2831853 * noise.x), sin(6.2831853 * noise.x)), a = start;
  float blockers = 0.0, way = 0.0;
  for (int i = 0; i < kSearched; ++i) {
    vec2 p = a * sqrt((float(i) + noise.y) / float(kSearched));
    vec2 offset = p.x * u + p.y * v + p * (0.8 * texel.y);
    float z = textureLod(shadowMap, m.xy + offset, 0.0).r;
    float blocked = z < min(m.z + dot(gradient, offset) - tilt * length(offset), kEmpty) ? 1.0 : 0.0;
    blockers += blocked;
    way += blocked * max(m.z - z, 0.0);
    a = kGolden * a;
  }
  bool some = blockers > 0.5;
  way = min(way / max(blockers, 1.0), kWidest / max(max(length(source.xy), length(source.zw)), 1e-9));
  u = source.xy * way;
  v = source.zw * way;
  a = start;
  float lit = 0.0;
  // A loop that ends at once where nothing is in the way: software GL runs through what an if holds.
  for (int i = 0, count = some ? kFiltered : 0; i < count; ++i) {
    vec2 p = a * sqrt((float(i) + noise.y) / float(kFiltered));
    vec2 offset = p.x * u + p.y * v + p * (0.8 * texel.y);
    // What lies farther than all casters is compared with the empty map too.
    lit += textureLod(shadowTest, vec3(m.xy + offset, min(m.z + dot(gradient, offset) - tilt * length(offset), kEmpty)), 0.0);
    a = kGolden * a;
  }
  return some ? lit / float(kFiltered) : 1.0;
}

#ifdef CONTACT
// What stands close by in the way to the light, as far as the picture shows it.
float contactVisibility(vec3 P, vec3 plane, vec3 L, float depth, float noise, bool wanted) {
  float size = pixelSize(depth);
  vec4 from = view.clipFromWorld * vec4(P + plane * (1.5 * size), 1.0), along = view.clipFromWorld * vec4(L * contactLength, 0.0);
  float hidden = 0.0, thickness = 0.5 * contactLength;
  for (int i = 0, count = wanted ? kContactSteps : 0; i < count; ++i) {
    float t = (float(i) + noise) / float(kContactSteps);
    vec4 clip = from + along * (t * t);
    vec3 ndc = clip.xyz / max(clip.w, 1e-9);
    ivec2 pixel = viewRectangle.xy + ivec2(floor((ndc.xy * 0.5 + 0.5) * vec2(viewRectangle.zw - viewRectangle.xy)));
    float behind = linearDepth(ndc.z * 0.5 + 0.5) - linearDepth(texelFetch(gDepth, clamp(pixel, viewRectangle.xy, viewRectangle.zw - 1), 0).r);
    // The last of the way counts less, so that it has no edge.
    if (inView(pixel) && behind > size && behind < thickness) hidden = max(hidden, min(3.0 - 3.0 * t, 1.0));
  }
  return 1.0 - hidden;
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depthValue = texelFetch(gDepth, pixel, 0).r;
  vec3 P = worldPosition(gl_FragCoord.xy, depthValue), N = normalize(texelFetch(gNormal, pixel, 0).xyz);
  vec3 toLight = towards.w > 0.0 ? towards.xyz - P : towards.xyz;
  float distance = max(length(toLight), 1e-9);
  vec3 L = toLight / distance, G = geometricNormal(pixel, P, depthValue);
  // A fine mesh is as smooth as its normals. Where they have little to do with its triangles, as under a normal map, those tell
  // where the surface goes on; unless it is a neighbour's, at an outline, or one that is turned away while its normal is not.
  float agreeing = dot(G, N), facing = dot(G, L);
  float triangle = (1.0 - smoothstep(0.978, 0.99, agreeing)) * smoothstep(0.0, 0.15, facing) * step(0.5, agreeing);
  vec3 plane = normalize(mix(N, G, triangle));
  vec2 noise = pixelNoise(gl_FragCoord.xy);
  // What is turned away is dark by its shading alone, and a large source is shaded as far as it is above the horizon: there a
  // map seen from its middle knows nothing more.
  float above = clamp(dot(N, L) / max(sine, 1e-3), 0.0, 1.0);
  float visibility = above > 0.0 ? mapVisibility(P, plane, L, distance, noise) : 1.0;
#ifdef CONTACT
  visibility *= contactVisibility(P, plane, L, linearDepth(depthValue), noise.y, above > 0.0 && facing > 0.05 && visibility > 0.0);
#endif
  outVisibility = mix(1.0, visibility, above);
}
