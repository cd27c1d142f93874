// The light of a shape through a cosine lobe that a matrix has turned into a model's (Heitz, Dupuy, Hill and Neubelt 2016;
// Heitz and Hill 2017 for the ellipse). Form factors: 1 where the shape fills all that the lobe sees.
//
// Every light runs through this at every pixel. Software GL waits for each root and division, of which one here needs the one
// before: two lights at a time do not wait for each other (16 spheres: 55 to 47 ms a frame, where 16 points take 31). And it
// runs through both sides of a branch: there are none.
#include "shaders/common/lights.glsl"

// A lobe of one view: its matrix as a rotation, a scale and a rotation, of which the last matters for the pole alone.
struct CosineLobe {
  mat3 axes;      // from world to its own axes: across it in the plane of the view, across it, along it
  vec3 stretch;   // what makes a cosine lobe of it, along these
  vec3 pole;      // the middle of that cosine lobe
  mat3 seen;      // stretch times axes
};

// `inverse` has xx, xz, zx and zz of the matrix, x in the plane of the view and z the normal; its yy is 1.
CosineLobe cosineLobe(vec3 N, vec3 V, vec4 inverse) {
  vec3 X = V - N * dot(N, V);
  float across = dot(X, X);
  X = across > 1e-8 ? X * inversesqrt(across) : normalize(abs(N.y) < 0.99 ? cross(vec3(0.0, 1.0, 0.0), N) : cross(N, vec3(1.0, 0.0, 0.0)));
  // Eigenvectors of the matrix' square.
  float xx = dot(inverse.xz, inverse.xz), zz = dot(inverse.yw, inverse.yw), xz = dot(inverse.xz, inverse.yw);
  float rest = 0.5 * (xx - zz), root = sqrt(rest * rest + xz * xz);
  vec2 w = rest >= 0.0 ? vec2(rest + root + 1e-20, xz) : vec2(xz, root - rest);
  w *= inversesqrt(dot(w, w));
  float wide = sqrt(0.5 * (xx + zz) + root), narrow = max(abs(inverse.x * inverse.w - inverse.y * inverse.z) / wide, 1e-6 * wide);
  CosineLobe lobe;
  lobe.axes = transpose(mat3(w.x * X + w.y * N, cross(N, X), w.x * N - w.y * X));
  lobe.stretch = vec3(wide, 1.0, narrow);
  lobe.pole = vec3(dot(inverse.zw, w) / wide, 0.0, (inverse.w * w.x - inverse.z * w.y) / narrow);
  lobe.seen = mat3(lobe.axes[0] * lobe.stretch, lobe.axes[1] * lobe.stretch, lobe.axes[2] * lobe.stretch);
  return lobe;
}

// Two vectors, of two lights.
struct Pair { vec2 x, y, z; };
Pair pairOf(vec3 a, vec3 b) { return Pair(vec2(a.x, b.x), vec2(a.y, b.y), vec2(a.z, b.z)); }
vec2 dotOf(Pair a, Pair b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec2 dotOf(vec3 a, Pair b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Pair crossOf(Pair a, Pair b) { return Pair(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
Pair scaled(Pair a, vec2 by) { return Pair(a.x * by, a.y * by, a.z * by); }
Pair moved(Pair a, Pair along, vec2 by) { return Pair(a.x + along.x * by, a.y + along.y * by, a.z + along.z * by); }
Pair turned(mat3 m, Pair a) {
  return Pair(m[0].x * a.x + m[1].x * a.y + m[2].x * a.z, m[0].y * a.x + m[1].y * a.y + m[2].y * a.z, m[0].z * a.x + m[1].z * a.y + m[2].z * a.z);
}

// The light of a disc that covers an angle with that sine, over the sine's cube, whose middle is `t` times the sine above the
// horizon: within a thousandth of itself when it is small, and a twentieth when it fills the sky.
vec2 discAboveHorizon(vec2 t, vec2 sine2) {
  vec2 u = max(0.5 + 0.5 * t, 0.0), x4 = sine2 * sine2;
  x4 *= x4;
  vec2 x16 = x4 * x4, small = u * u * (0.395 + u * (1.21 - 0.605 * u)), large = 0.22 * sine2 + 0.3 * x4 + 0.48 * (x16 * x16);
  return mix(small + (u - small) * large, t, greaterThanEqual(t, vec2(1.0)));
}

// Through a lobe, of discs towards `center` that cover angles with those sines squared: the ellipses that the lobe sees. The
// cone of such a disc's directions w is where k w.w - (w.c)^2 < 0. Stretched, that is a quadratic form with the eigenvalue -m
// where the sum of c_i^2 (sine2 - m s_i^2) / (k + m s_i^2) is 0, and -m over the two others are the tangents of its widths, squared.
vec2 discsThrough(CosineLobe lobe, Pair center, vec2 sine2) {
  Pair c = turned(lobe.axes, center);
  vec3 s2 = lobe.stretch * lobe.stretch;
  vec2 x2 = c.x * c.x, y2 = c.y * c.y, z2 = c.z * c.z, k = 1.0 - sine2, across = x2 + y2 + 1e-20, whole = 2.0 * (across + z2);
  // Were both widths across the lobe the same, it would be a root of a quadratic equation. That is below the true one and
  // close to it; a step of Newton's comes closer.
  vec2 wide = (x2 * s2.x + y2 * s2.y + 1e-20) / across, a = whole * wide * s2.z, c0 = whole * k * sine2;
  vec2 b = k * (across * wide + z2 * s2.z) - sine2 * (across * s2.z + z2 * wide), root = sqrt(b * b + a * c0);
  bvec2 above = greaterThan(b, vec2(0.0));
  vec2 m = mix(root - b, c0, above) / mix(a, b + root, above);
  Pair r = Pair(1.0 / (k + m * s2.x), 1.0 / (k + m * s2.y), 1.0 / (k + m * s2.z)), e = Pair(x2 * r.x, y2 * r.y, z2 * r.z);
  vec2 more = (sine2 * (e.x + e.y + e.z) - m * dotOf(s2, e)) / (e.x * r.x * s2.x + e.y * r.y * s2.y + e.z * r.z * s2.z);
  m += more;
  r = Pair(1.0 / (k + m * s2.x), 1.0 / (k + m * s2.y), 1.0 / (k + m * s2.z));
  Pair axis = Pair(c.x * r.x * lobe.stretch.x, c.y * r.y * lobe.stretch.y, c.z * r.z * lobe.stretch.z);
  vec2 size = m * sqrt(0.5 * whole * r.x * r.y * r.z) * (lobe.stretch.x * lobe.stretch.y * lobe.stretch.z), q = inversesqrt(size * sqrt(dotOf(axis, axis)) + 1e-20), sine = min(size * q, 1.0);
  return sine * sine * sine * discAboveHorizon(dotOf(lobe.pole, axis) * q, sine * sine);
}

// Parallelograms as they are seen: the middle, and half of their sides.
struct Quads { Pair c, u, v; };

// What of them is above the horizon: about as much, in about the same place, as parallelograms too.
struct Cut { vec2 keptU, keptV, movedU, movedV; };
Cut cutOf(Quads q, vec3 N) {
  vec2 h = dotOf(N, q.c), hu = dotOf(N, q.u), hv = dotOf(N, q.v), most = abs(hu) + abs(hv), above = max(most + h, 0.0), below = max(most - h, 0.0);
  // The cut goes to the side that climbs, or to both where both do.
  vec2 u2 = hu * hu, v2 = hv * hv, all = u2 + v2, square = above * (all * all) + 1e-20;
  Cut cut;
  cut.keptU = square / (square + below * u2 * (0.66 * all + 0.34 * u2));
  cut.keptV = square / (square + below * v2 * (0.66 * all + 0.34 * v2));
  cut.movedU = mix(1.0 - cut.keptU, cut.keptU - 1.0, lessThan(hu, vec2(0.0)));
  cut.movedV = mix(1.0 - cut.keptV, cut.keptV - 1.0, lessThan(hv, vec2(0.0)));
  return cut;
}
Quads cutTo(Quads q, Cut cut) { return Quads(moved(moved(q.c, q.u, cut.movedU), q.v, cut.movedV), scaled(q.u, cut.keptU), scaled(q.v, cut.keptV)); }

// 1 + x of an angle's cosine x: the angle over its sine, times n. acos(c) / sqrt(1 - c^2) of the cosine of half of it is smooth.
vec2 angleOverSine(vec2 x, vec2 n) {
  vec2 c2 = abs(x) + 1e-7, c = sqrt(c2);
  return (n / c) * ((2.2212057 - 0.9911858 * c) + c2 * ((0.4995267 - 0.1965909 * c) + c2 * 0.0379739));
}
// Of the four edges from -v on, the angles that they cover, over their sines and the lengths to their ends: by the squares and
// products of the three vectors.
struct Edges { vec2 a, b, c, d; };
Edges edgesOf(vec2 cc, vec2 uu, vec2 vv, vec2 cu, vec2 cv, vec2 uv) {
  vec2 all = cc + uu + vv, sum = 2.0 * (cu + cv), difference = 2.0 * (cu - cv), even = all + 2.0 * uv, odd = all - 2.0 * uv;
  vec2 a = inversesqrt(abs(even - sum) + 1e-15), b = inversesqrt(abs(odd + difference) + 1e-15), c = inversesqrt(abs(even + sum) + 1e-15), d = inversesqrt(abs(odd - difference) + 1e-15);
  vec2 ab = a * b, bc = b * c, cd = c * d, da = d * a, acrossV = cc - uu + vv, acrossU = cc + uu - vv;
  return Edges(angleOverSine(1.0 + ab * (acrossV - 2.0 * cv), ab), angleOverSine(1.0 + bc * (acrossU + 2.0 * cu), bc),
               angleOverSine(1.0 + cd * (acrossV + 2.0 * cv), cd), angleOverSine(1.0 + da * (acrossU - 2.0 * cu), da));
}

// Through a lobe, of quads that turn one of their sides this way. What is below the lobe's own horizon is cut off as of a sphere
// of the same flux.
vec2 quadsThrough(CosineLobe lobe, Quads quads, Cut cut, float side) {
  Quads q = cutTo(Quads(turned(lobe.seen, quads.c), turned(lobe.seen, quads.u), turned(lobe.seen, quads.v)), cut);
  Edges w = edgesOf(dotOf(q.c, q.c), dotOf(q.u, q.u), dotOf(q.v, q.v), dotOf(q.c, q.u), dotOf(q.c, q.v), dotOf(q.u, q.v));
  Pair flux = moved(moved(scaled(crossOf(q.c, q.u), w.a - w.c), crossOf(q.c, q.v), w.b - w.d), crossOf(q.u, q.v), w.a + w.b + w.c + w.d);
  vec2 square = dotOf(flux, flux) * (1.0 / (kPi * kPi)) + 1e-20, size = sqrt(square), cube = sqrt(square * size);
  return cube * discAboveHorizon(dotOf(lobe.pole, flux) * (side / kPi) / cube, min(size, 1.0));
}

// What a surface sends on of two lights of 1 candela: `specular` pi times the mean radiance that its lobe sees, `coat` that of
// another, and the irradiance.
struct Seen { vec2 specular, coat, irradiance; };

Seen seenSpheres(PlacedLight one, PlacedLight two, vec3 N, CosineLobe lobe, CosineLobe coat) {
  // Radiance 1 / (pi R^2); from inside it is everywhere.
  Pair center = pairOf(one.center, two.center);
  vec2 size = max(vec2(one.extent.x, two.extent.x), 1e-6), scale = 1.0 / (size * size);
  vec2 near = inversesqrt(dotOf(center, center) + 1e-20), sine = size * near, height = dotOf(N, center), t = height / size;
  // What is below the horizon is cut off: the rest is a disc of the same area around its own middle.
  vec2 level = clamp(t, -1.0, 1.0), w = 0.5 - 0.5 * level, up = sine * w * (0.463 + w * (1.006 - 0.469 * w)), down = near - up * height * near * near;
  Pair middle = Pair(center.x * down + N.x * up, center.y * down + N.y * up, center.z * down + N.z * up);
  vec2 cut = sine * sine * max(0.5 + level * (0.645 - 0.145 * level * level), 0.0);
  bvec2 inside = greaterThan(sine, vec2(0.9999));
  return Seen(scale * mix(discsThrough(lobe, middle, cut), vec2(1.0), inside), scale * mix(discsThrough(coat, middle, cut), vec2(1.0), inside),
              scale * mix(sine * sine * sine * discAboveHorizon(t, sine * sine), vec2(1.0), inside));
}

// A tube shows its axis with its width, and its round ends as a little more length.
Seen seenTubes(PlacedLight one, PlacedLight two, vec3 N, CosineLobe lobe, CosineLobe coat) {
  Pair center = pairOf(one.center, two.center), along = pairOf(one.along, two.along), across = crossOf(center, along);
  vec2 cc = dotOf(center, center), cu = dotOf(center, along), uu = dotOf(along, along);
  vec2 radius = vec2(one.extent.x, two.extent.x) + 1e-3 * sqrt(cc), long1 = sqrt(uu), scale = 1.0 / (kPi * radius * (radius + long1)), turned2 = dotOf(across, across) + 1e-12;
  // Longer along the axis by what half a disc would be at right angles to the way to it; where the way is along the axis, across.
  vec2 turned1 = inversesqrt(turned2), ends = 0.25 * kPi * radius, most = 3.0 * ends / long1, closeness = inversesqrt(cc + 1e-12);
  vec2 first = min(ends * turned1 * sqrt(cc - 2.0 * cu + uu), most), last = min(ends * turned1 * sqrt(cc + 2.0 * cu + uu), most);
  vec2 aside = max(1.0 - turned2 * turned1 * closeness / long1, 0.0) * ends * turned1 * closeness;
  vec2 wide = radius * inversesqrt(max(turned2 - radius * radius * uu, 0.01 * turned2));
  Quads q = Quads(moved(center, along, 0.5 * (last - first)), moved(scaled(along, 1.0 + 0.5 * (first + last) + aside * cc), center, -aside * cu), scaled(across, wide));
  Cut cut = cutOf(q, N);
  vec2 specular = quadsThrough(lobe, q, cut, 1.0), coated = quadsThrough(coat, q, cut, 1.0);
  // The irradiance of a strip that faces the viewer: along its middle, the integral of the two cosines over the squared distance.
  q = cutTo(q, cut);
  vec2 h = dotOf(N, q.c), hu = dotOf(N, q.u);
  cc = dotOf(q.c, q.c), cu = dotOf(q.c, q.u), uu = dotOf(q.u, q.u);
  vec2 near = cc - 2.0 * cu + uu, far = cc + 2.0 * cu + uu, n2 = 1.0 / (near * far + 1e-20), n = sqrt(n2);
  vec2 strip = (h * uu - hu * cu) * ((near + far) * n2 + 2.0 * angleOverSine(1.0 + (cc - uu) * n, n)) + (hu * cc - h * cu) * cu * 4.0 * n2;
  return Seen(specular * (kPi * scale), coated * (kPi * scale), max(strip, 0.0) * inversesqrt(abs(cc * uu - cu * cu) + 1e-12) * radius * cut.keptV * scale);
}

Seen seenRectangles(PlacedLight one, PlacedLight two, vec3 N, CosineLobe lobe, CosineLobe coat) {
  Quads q = Quads(pairOf(one.center, two.center), pairOf(one.along, two.along), pairOf(one.up, two.up));
  vec2 scale = mix(vec2(0.0), vec2(one.extent.x, two.extent.x), lessThan(dotOf(q.c, crossOf(q.u, q.v)), vec2(0.0)));  // none behind it
  Cut cut = cutOf(q, N);
  vec2 specular = quadsThrough(lobe, q, cut, -1.0), coated = quadsThrough(coat, q, cut, -1.0);
  q = cutTo(q, cut);
  Edges w = edgesOf(dotOf(q.c, q.c), dotOf(q.u, q.u), dotOf(q.v, q.v), dotOf(q.c, q.u), dotOf(q.c, q.v), vec2(0.0));
  Pair aside = crossOf(q.c, Pair(vec2(N.x), vec2(N.y), vec2(N.z)));
  vec2 irradiance = dotOf(aside, q.u) * (w.a - w.c) + dotOf(aside, q.v) * (w.b - w.d) - dotOf(N, crossOf(q.u, q.v)) * (w.a + w.b + w.c + w.d);
  return Seen(specular * (kPi * scale), coated * (kPi * scale), max(irradiance, 0.0) * scale);
}

// Both of one kind.
Seen seenLights(PlacedLight one, PlacedLight two, vec3 N, CosineLobe lobe, CosineLobe coat) {
  if (one.kind == kSphereLight) return seenSpheres(one, two, N, lobe, coat);
  if (one.kind == kTubeLight) return seenTubes(one, two, N, lobe, coat);
  return seenRectangles(one, two, N, lobe, coat);
}
