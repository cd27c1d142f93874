// The light of a shape through a cosine lobe that a matrix has turned into a model's (Heitz, Dupuy, Hill and Neubelt 2016;
// Heitz and Hill 2017 for the ellipse). Form factors: 1 where the shape fills all that the lobe sees.
#include "shaders/common/lights.glsl"

// A lobe of one view: frame x in the plane of the view, z the normal.
struct CosineLobe {
  mat3 fromWorld;      // into that frame, and then into that of the cosine
  mat3 toWorld;        // its inverse
  float density;       // |determinant| of fromWorld
};

CosineLobe cosineLobe(vec3 N, vec3 V, vec4 inverse) {
  vec3 X = V - N * dot(N, V);
  float across = dot(X, X);
  X = across > 1e-8 ? X * inversesqrt(across) : normalize(abs(N.y) < 0.99 ? cross(vec3(0.0, 1.0, 0.0), N) : cross(N, vec3(1.0, 0.0, 0.0)));
  mat3 frame = mat3(X, cross(N, X), N);
  mat3 m = mat3(inverse.x, 0.0, inverse.z, 0.0, 1.0, 0.0, inverse.y, 0.0, inverse.w);
  float d = inverse.x * inverse.w - inverse.y * inverse.z;
  mat3 back = mat3(inverse.w, 0.0, -inverse.z, 0.0, d, 0.0, -inverse.y, 0.0, inverse.x) * (1.0 / d);
  return CosineLobe(m * transpose(frame), frame * back, abs(d));
}

// sphereFormFactor() to a few hundredths, for a fraction of its time.
float discAboveHorizon(float cosine, float sine2) {
  float sine = sqrt(sine2), above = max(sine + cosine, 0.0);
  return sine2 * (cosine >= sine ? cosine : above * above / max(4.0 * sine, 1e-9));
}

// Cuts off what of a round thing towards `center` (unit), which covers an angle with that sine squared, is below the horizon:
// the rest is a disc of the same area around its own middle.
void cutAtHorizon(vec3 N, inout vec3 center, inout float sine2) {
  float height = dot(N, center), sine = sqrt(sine2), t = clamp(height / max(sine, 1e-6), -1.0, 1.0), rest = 1.0 - t * t;
  // The share of a disc above a chord, and where its middle lies.
  float seen = 0.5 + t * (0.75 - 0.25 * t * t);
  center += (N - height * center) * (sine * 0.2122066 * rest * sqrt(rest) / max(seen, 1e-3));
  sine2 *= seen;
}

// Through a lobe, of a disc above the horizon towards `center`: the ellipse that the lobe sees (Heitz and Hill 2017).
float discThrough(CosineLobe lobe, vec3 center, float sine2) {
  center = normalize(center);
  vec3 c = lobe.fromWorld * center;
  float shorter = inversesqrt(dot(c, c)), size2 = sine2 * lobe.density * (shorter * shorter * shorter);
  // A small one is its middle.
  if (size2 < 2.5e-3) return max(c.z * shorter, 0.0) * size2;
  // The cone of its directions is where a quadratic form is negative; written without differences of large numbers.
  vec3 ax = cross(lobe.toWorld[0], center), ay = cross(lobe.toWorld[1], center), az = cross(lobe.toWorld[2], center);
  float xx = dot(ax, ax) - sine2 * dot(lobe.toWorld[0], lobe.toWorld[0]), yy = dot(ay, ay) - sine2 * dot(lobe.toWorld[1], lobe.toWorld[1]),
        zz = dot(az, az) - sine2 * dot(lobe.toWorld[2], lobe.toWorld[2]), xy = dot(ax, ay) - sine2 * dot(lobe.toWorld[0], lobe.toWorld[1]),
        xz = dot(ax, az) - sine2 * dot(lobe.toWorld[0], lobe.toWorld[2]), yz = dot(ay, az) - sine2 * dot(lobe.toWorld[1], lobe.toWorld[2]);
  // Its eigenvalues (Smith 1961), one of them negative.
  float mean = (xx + yy + zz) / 3.0;
  vec3 diagonal = vec3(xx, yy, zz) - mean;
  float spread = sqrt(max((dot(diagonal, diagonal) + 2.0 * (xy * xy + xz * xz + yz * yz)) / 6.0, 1e-30));
  diagonal /= spread;
  vec3 off = vec3(yz, xz, xy) / spread;
  float determinant = diagonal.x * (diagonal.y * diagonal.z - off.x * off.x) - off.z * (off.z * diagonal.z - off.x * off.y) +
                      off.y * (off.z * off.x - diagonal.y * off.y);
  float angle = acos(clamp(0.5 * determinant, -1.0, 1.0)) / 3.0;
  float largest = mean + 2.0 * spread * cos(angle), least = mean + 2.0 * spread * cos(angle + 2.0 * kPi / 3.0), second = 3.0 * mean - largest - least;
  vec3 rowX = vec3(xx - least, xy, xz), rowY = vec3(xy, yy - least, yz), rowZ = vec3(xz, yz, zz - least);
  vec3 axis = cross(rowX, rowY), other = cross(rowY, rowZ);
  if (dot(other, other) > dot(axis, axis)) axis = other;
  other = cross(rowZ, rowX);
  if (dot(other, other) > dot(axis, axis)) axis = other;
  axis = dot(axis, axis) > 1e-30 ? normalize(axis) : c * shorter;
  float tan2 = max(-least / max(largest, 1e-20), 0.0), tan2b = max(-least / max(second, 1e-20), 0.0);
  return discAboveHorizon(dot(axis, c) < 0.0 ? -axis.z : axis.z, sqrt(tan2 / (1.0 + tan2)) * sqrt(tan2b / (1.0 + tan2b)));
}

// Over 2 pi, of an edge between two unit vectors: their cross product by the angle over its sine.
vec3 edgeFormFactor(vec3 a, vec3 b) {
  float x = dot(a, b), y = abs(x);
  float v = (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
  return cross(a, b) * (x > 0.0 ? v : 0.5 * inversesqrt(max(1.0 - x * x, 1e-7)) - v);
}

// The corners of a light as it is seen, for lights that are no spheres.
struct LightQuad { vec3 a, b, c, d; };
LightQuad quadOf(PlacedLight light) {
  if (light.kind == kRectangleLight) {
    vec3 x = light.extent.x * light.right, y = light.extent.y * cross(light.axis, light.right);
    return LightQuad(light.center - x - y, light.center + x - y, light.center + x + y, light.center - x + y);
  }
  // A tube shows its axis with its width, and its round ends as a little more length.
  vec3 from = light.center - light.extent.y * light.axis, to = light.center + light.extent.y * light.axis;
  float radius = max(light.extent.x, 1e-3 * length(light.center));
  vec3 across = cross(light.center, light.axis);
  float turned = dot(across, across);
  across = turned > 1e-12 ? across * (radius * inversesqrt(turned)) : vec3(0.0);
  vec3 ahead = normalize(from), beyond = normalize(to);
  vec3 first = light.axis - dot(light.axis, ahead) * ahead, last = light.axis - dot(light.axis, beyond) * beyond;
  from -= first * (0.25 * kPi * radius * inversesqrt(max(dot(first, first), 1e-8)));
  to += last * (0.25 * kPi * radius * inversesqrt(max(dot(last, last), 1e-8)));
  return LightQuad(from - across, to - across, to + across, from + across);
}

// Through a lobe, of a flat or twisted quadrilateral. Its part below the cosine's horizon is cut
// off as a sphere of the same form factor would be.
float quadThrough(mat3 fromWorld, LightQuad q) {
  vec3 a = normalize(fromWorld * q.a), b = normalize(fromWorld * q.b), c = normalize(fromWorld * q.c), d = normalize(fromWorld * q.d);
  vec3 sum = edgeFormFactor(a, b) + edgeFormFactor(b, c) + edgeFormFactor(c, d) + edgeFormFactor(d, a);
  float size = length(sum);
  if (size < 1e-12) return 0.0;
  vec3 towards = sum / size;
  if (dot(towards, a + c) < 0.0) towards = -towards;
  return discAboveHorizon(towards.z, min(size, 1.0));
}

// The share of it that is above the horizon, about.
float seenOf(LightQuad q, vec3 N) {
  vec4 heights = vec4(dot(N, q.a), dot(N, q.b), dot(N, q.c), dot(N, q.d));
  return dot(max(heights, 0.0), vec4(1.0)) / max(dot(abs(heights), vec4(1.0)), 1e-12);
}

// What a surface sends on of a light of 1 candela: `specular` pi times the mean radiance that its lobe sees, `coat` that of
// another, and the irradiance.
struct Seen { float specular, coat, irradiance; };
Seen seenLight(PlacedLight light, vec3 N, CosineLobe lobe, CosineLobe coat) {
  float distance2 = dot(light.center, light.center);
  if (light.kind == kSphereLight) {
    // Radiance 1 / (pi R^2); from inside it is everywhere.
    float size2 = max(light.extent.x * light.extent.x, 1e-12), sine2 = min(size2 / max(distance2, 1e-12), 1.0), cut = sine2, scale = 1.0 / size2;
    vec3 center = light.center * inversesqrt(max(distance2, 1e-12)), middle = center;
    cutAtHorizon(N, middle, cut);
    return sine2 < 1.0 ? Seen(discThrough(lobe, middle, cut) * scale, discThrough(coat, middle, cut) * scale, discAboveHorizon(dot(N, center), sine2) * scale)
                       : Seen(scale, scale, scale);
  }
  LightQuad q = quadOf(light);
  float seen = seenOf(q, N);
  if (light.kind == kTubeLight) {
    float radius = max(light.extent.x, 1e-3 * sqrt(distance2)), scale = seen / (radius * (radius + light.extent.y));
    vec3 along = light.extent.y * light.axis;
    return Seen(quadThrough(lobe.fromWorld, q) * scale, quadThrough(coat.fromWorld, q) * scale,
                clippedLineIrradiance(N, light.center - along, light.center + along));
  }
  float scale = dot(light.center, light.axis) < 0.0 ? kPi / (light.extent.x * light.extent.y) : 0.0;  // none behind a rectangle
  return Seen(quadThrough(lobe.fromWorld, q) * seen * scale, quadThrough(coat.fromWorld, q) * seen * scale, quadThrough(cosineLobe(N, N, vec4(1.0, 0.0, 0.0, 1.0)).fromWorld, q) * scale);
}
