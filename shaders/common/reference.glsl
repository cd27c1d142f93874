// What a model sends to the viewer of lights with a surface, by Monte Carlo: directions drawn from the light and from the
// model, weighted by the balance heuristic (Veach and Guibas 1995). Right on average for every model whose parts are
// finite; only how much it scatters depends on how well the proposals fit. After the model's own text and lights.glsl.

// False once a sample was not finite. It then counts as black.
bool referenceSound = true;

// Jarzynski and Olano 2020, pcg3d.
uvec3 referenceHash(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Roberts 2018, the additive sequences R2 and R3, in fixed point so that late samples are as even as early ones; turned
// by an offset (Cranley and Patterson 1976). In (0, 1).
vec3 referenceUnit(uvec3 v) { return (vec3(v >> 9u) + 0.5) * (1.0 / 8388608.0); }
vec2 referenceTwo(uint i, uvec3 offset) { return referenceUnit(i * uvec3(3242174889u, 2447445414u, 0u) + offset).xy; }
vec3 referenceThree(uint i, uvec3 offset) { return referenceUnit(i * uvec3(3518319155u, 2882110345u, 2360945575u) + offset); }

// ---- directions from the model

// A mixture: by the cosine, by the visible normals of a GGX as wide as the model's lobe, likewise of its coat, and over the
// whole sphere where light comes through from behind.
struct Proposal {
  mat3 frame;       // along the lobe's long side, across it, and the normal
  vec3 view;        // in that frame, above the surface
  vec2 alpha;
  float coatAlpha;
  vec4 share;       // of the four, together 1
};

// Roots of the width, as alpha, at the roughness of each level (EnvironmentLighting::levelRoughness), and what the lobe is
// longer along the tangent and bitangent.
uniform float lobeRoots[6], coatRoots[6];
uniform vec2 lobeStretch[6];

float referenceLevel(float roughness) { return clamp(5.0 * roughness * (1.7 - 0.7 * roughness), 0.0, 4.9999); }

Proposal referenceProposal(Shading s, Parameters p) {
  Proposal q;
  float level = modelReadsRoughness ? referenceLevel(s.roughness) : 1.0;
  int below = int(level);
  float root = mix(lobeRoots[below], lobeRoots[below + 1], level - float(below));
  q.alpha = vec2(root * root);
  vec3 X = s.T;
#ifdef MODEL_TANGENT
  vec2 stretch = mix(lobeStretch[below], lobeStretch[below + 1], level - float(below));
  float length2 = dot(stretch, stretch);
  if (length2 > 0.0) {
    X = normalize(stretch.x * s.T + stretch.y * s.B);
    q.alpha.x = sqrt(q.alpha.x * q.alpha.x + length2);
  }
#endif
  q.alpha = clamp(q.alpha, 3e-4, 1.0);
  q.frame = mat3(X, cross(s.N, X), s.N);
  q.view = s.V * q.frame;
  q.view = normalize(vec3(q.view.xy, max(q.view.z, 1e-4)));
  float diffuse = max(s.diffuseColor.r, max(s.diffuseColor.g, s.diffuseColor.b));
  float specular = max(s.F0.r, max(s.F0.g, s.F0.b)) + 0.1;
  float cosine = clamp(diffuse / max(diffuse + specular, 1e-6), 0.25, 0.6);
  q.share = vec4(cosine, 1.0 - cosine, 0.0, 0.0);
  q.coatAlpha = 1.0;
#ifdef MODEL_COAT
  float coatLevel = referenceLevel(clamp(modelCoatRoughness(p), 0.0, 1.0));
  int coatBelow = int(coatLevel);
  float coatRoot = mix(coatRoots[coatBelow], coatRoots[coatBelow + 1], coatLevel - float(coatBelow));
  q.coatAlpha = clamp(coatRoot * coatRoot, 3e-4, 1.0);
  q.share = vec4(0.7 * q.share.xy, 0.3, 0.0);
#endif
  if (modelScatters) q.share = vec4(0.75 * q.share.xyz, 0.25);
  return q;
}

// Dupuy and Benyoub 2023: visible normals of GGX.
vec3 referenceNormal(vec2 u, vec3 V, vec2 alpha) {
  vec3 v = normalize(vec3(alpha * V.xy, V.z));
  float phi = 2.0 * kPi * u.x, z = (1.0 - u.y) * (1.0 + v.z) - v.z;
  vec3 h = v + vec3(sqrt(clamp(1.0 - z * z, 0.0, 1.0)) * vec2(cos(phi), sin(phi)), z);
  return normalize(vec3(alpha * h.xy, max(h.z, 1e-7)));
}

// Of the light, per steradian: G1 D / (4 NoV).
float referenceLobePdf(vec3 V, vec3 L, vec2 alpha) {
  vec3 H = V + L;
  float length2 = dot(H, H);
  if (H.z <= 0.0 || length2 < 1e-12) return 0.0;
  H *= inversesqrt(length2);
  vec3 m = vec3(H.xy / alpha, H.z);
  float k = dot(m, m);
  vec2 across = alpha * V.xy;
  return 0.5 / (kPi * alpha.x * alpha.y * k * k * (V.z + sqrt(dot(across, across) + V.z * V.z)));
}

vec3 referenceDirection(Proposal q, vec3 u) {
  float upTo = q.share.x;
  if (u.z < upTo) {
    float phi = 2.0 * kPi * u.x, r = sqrt(u.y);
    return q.frame * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.y));
  }
  upTo += q.share.y + q.share.z;
  if (u.z < upTo) {
    vec3 H = referenceNormal(u.xy, q.view, u.z < q.share.x + q.share.y ? q.alpha : vec2(q.coatAlpha));
    return q.frame * (2.0 * dot(q.view, H) * H - q.view);
  }
  float z = 2.0 * u.y - 1.0, r = sqrt(max(1.0 - z * z, 0.0)), phi = 2.0 * kPi * u.x;
  return q.frame * vec3(r * cos(phi), r * sin(phi), z);
}

float referenceDirectionPdf(Proposal q, vec3 L) {
  vec3 l = L * q.frame;
  float pdf = q.share.x * max(l.z, 0.0) / kPi + q.share.y * referenceLobePdf(q.view, l, q.alpha) + q.share.w / (4.0 * kPi);
#ifdef MODEL_COAT
  pdf += q.share.z * referenceLobePdf(q.view, l, vec2(q.coatAlpha));
#endif
  return pdf;
}

// What a model sends on of light of radiance 1 from a direction, per steradian.
#ifndef REFERENCE_LIT
#define REFERENCE_LIT modelLit
#endif
vec3 referenceSentOn(inout Shading s, Parameters p, vec3 L) {
  setLight(s, L);
  float cosine = dot(s.N, L);
  vec3 f = vec3(0.0);
  if (cosine > 0.0) f = REFERENCE_LIT(s, p) * cosine;
  if (modelScatters) f += modelScattered(s, p);
  return f;
}

vec3 referenceFinite(vec3 c) {
  if (abs(c.r) + abs(c.g) + abs(c.b) < 1e30) return c;
  referenceSound = false;
  return vec3(0.0);
}

// ---- directions to a light with a surface

// One over the density, over the surface, of a point that lies `t` along L on a surface with this normal: per steradian.
float referenceAreaPdf(float t, vec3 L, vec3 normal, float area) { return t * t / (area * max(abs(dot(normal, L)), 1e-7)); }

vec3 referenceToSphere(PlacedLight light, vec2 u) {
  float distance2 = dot(light.center, light.center), sine2 = light.extent.x * light.extent.x / distance2, phi = 2.0 * kPi * u.x;
  // From within it is all around.
  if (!(sine2 < 1.0)) {
    float z = 2.0 * u.y - 1.0, r = sqrt(max(1.0 - z * z, 0.0));
    return vec3(r * cos(phi), r * sin(phi), z);
  }
  // 1 - cos, whole and of the sample, without cancellation.
  float off = u.y * sine2 / (1.0 + sqrt(1.0 - sine2));
  vec3 Z = light.center * inversesqrt(distance2), X = anyTangent(Z), Y = cross(Z, X);
  return normalize((1.0 - off) * Z + sqrt(off * (2.0 - off)) * (cos(phi) * X + sin(phi) * Y));
}
float referenceSpherePdf(PlacedLight light, vec3 L) {
  float distance2 = dot(light.center, light.center), sine2 = light.extent.x * light.extent.x / distance2;
  if (!(sine2 < 1.0)) return 1.0 / (4.0 * kPi);
  float along = dot(light.center, L);
  vec3 beside = light.center - along * L;
  if (along <= 0.0 || dot(beside, beside) >= light.extent.x * light.extent.x) return 0.0;
  return (1.0 + sqrt(1.0 - sine2)) / (2.0 * kPi * sine2);
}

// A capsule, evenly over its surface: the caps are the two halves of a sphere.
vec3 referenceToTube(PlacedLight light, vec2 u) {
  float radius = light.extent.x, half_ = length(light.along), caps = radius / (radius + half_), phi = 2.0 * kPi * u.y;
  vec3 axis = light.along / half_, right = anyTangent(axis), around = cos(phi) * right + sin(phi) * cross(axis, right), point;
  if (u.x < caps) {
    float z = 2.0 * u.x / caps - 1.0;
    point = radius * (sqrt(max(1.0 - z * z, 0.0)) * around + z * axis) + (z < 0.0 ? -1.0 : 1.0) * light.along;
  } else {
    point = radius * around + (2.0 * (u.x - caps) / (1.0 - caps) - 1.0) * light.along;
  }
  return normalize(light.center + point);
}
// A direction meets it where it enters and where it leaves: both points could have been drawn. From within only one can.
float referenceTubePdf(PlacedLight light, vec3 L) {
  float radius = light.extent.x, half_ = length(light.along), radius2 = radius * radius, area = 4.0 * kPi * radius * (radius + half_);
  vec3 axis = light.along / half_;
  float along = dot(light.center, axis), turned = dot(L, axis);
  vec3 across = light.center - along * axis, sideways = L - turned * axis;
  float pdf = 0.0, k = dot(sideways, sideways);
  if (k > 1e-10) {
    float t = dot(across, sideways) / k;
    vec3 beside = across - t * sideways;
    float rest = radius2 - dot(beside, beside);
    if (rest <= 0.0) return 0.0;
    float halfChord = sqrt(rest / k);
    for (int side = -1; side <= 1; side += 2) {
      float at = t + float(side) * halfChord;
      if (at > 0.0 && abs(at * turned - along) <= half_) pdf += referenceAreaPdf(at, L, (at * sideways - across) / radius, area);
    }
  }
  for (int end = -1; end <= 1; end += 2) {
    vec3 center = light.center + float(end) * light.along;
    float t = dot(center, L);
    vec3 beside = center - t * L;
    float rest = radius2 - dot(beside, beside);
    if (rest <= 0.0) continue;
    float halfChord = sqrt(rest);
    for (int side = -1; side <= 1; side += 2) {
      float at = t + float(side) * halfChord;
      vec3 normal = (at * L - center) / radius;
      if (at > 0.0 && dot(normal, axis) * float(end) > 0.0) pdf += referenceAreaPdf(at, L, normal, area);
    }
  }
  return pdf;
}

vec3 referenceToRectangle(PlacedLight light, vec2 u) {
  vec2 at = 2.0 * u - 1.0;
  return normalize(light.center + at.x * light.along + at.y * light.up);
}
float referenceRectanglePdf(PlacedLight light, vec3 L) {
  vec3 axis = normalize(cross(light.along, light.up));
  float facing = dot(L, axis);
  if (facing >= 0.0) return 0.0;
  float t = dot(light.center, axis) / facing, width2 = dot(light.along, light.along), height2 = dot(light.up, light.up);
  vec3 point = t * L - light.center;
  bool inside = t > 0.0 && abs(dot(point, light.along)) <= width2 && abs(dot(point, light.up)) <= height2;
  return inside ? referenceAreaPdf(t, L, axis, 4.0 * sqrt(width2 * height2)) : 0.0;
}

vec3 referenceToLight(PlacedLight light, vec2 u) {
  return light.kind == kSphereLight ? referenceToSphere(light, u) : light.kind == kTubeLight ? referenceToTube(light, u) : referenceToRectangle(light, u);
}
// 0 where it does not shine from there.
float referenceLightPdf(PlacedLight light, vec3 L) {
  return light.kind == kSphereLight ? referenceSpherePdf(light, L)
                                    : light.kind == kTubeLight ? referenceTubePdf(light, L) : referenceRectanglePdf(light, L);
}
// Of 1 candela: nitsPerCandela() of renderer/light.h.
float referenceRadiance(PlacedLight light) {
  float a = light.extent.x;
  return light.kind == kRectangleLight ? a : 1.0 / (kPi * a * (light.kind == kSphereLight ? a : a + length(light.along)));
}

// The mean of `count` samples from the `first` on, of each kind.
vec3 referenceLight(PlacedLight light, Shading s, Parameters p, Proposal q, uint first, int count, uvec3 offset) {
  vec3 sum = vec3(0.0);
  uvec3 other = referenceHash(offset);
  for (int i = 0; i < count; ++i) {
    uint index = first + uint(i);
    vec3 part = vec3(0.0);
    for (int kind = 0; kind < 2; ++kind) {
      vec3 L = kind == 0 ? referenceToLight(light, referenceTwo(index, offset)) : referenceDirection(q, referenceThree(index, other));
      float pdf = referenceLightPdf(light, L);
      if (pdf > 0.0) part += referenceSentOn(s, p, L) / (pdf + referenceDirectionPdf(q, L));
    }
    sum += referenceFinite(part);
  }
  return sum * (referenceRadiance(light) / float(count));
}
