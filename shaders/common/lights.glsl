// Lights that have a place: how much arrives at a shaded point, and from where (renderer/light.h).
#include "shaders/terms/light.glsl"

// LightKind of renderer/light.h.
const int kSpotLight = 2, kSphereLight = 3, kTubeLight = 4, kRectangleLight = 5;

// Of 1 candela, seen from the shaded point.
struct PlacedLight {
  int kind;
  vec3 center;          // from the shaded point, metres
  float inverseRange2;  // 1 / the window's radius^2
  float constant;       // of eq. 9, m^2
  vec3 along;           // spot: unit, the way it shines; tube: half of its axis; rectangle: half of its width
  vec3 up;              // rectangle: half of its height; it shines along cross(along, up)
  vec2 extent;          // sphere and tube: radius, -; rectangle: its radiance, -
                        // spot: scale and offset of the cosine, whose square is the profile
};
const int kPlacedLightTexels = 4;

// Eq. 9 against the plain inverse square: the window, and the constant that keeps it finite. What every light is
// multiplied by whose own falloff is nature's.
float attenuation(PlacedLight light) {
  float distance2 = dot(light.center, light.center);
  return windowedFalloff(distance2, light.inverseRange2, light.constant) * distance2;
}

// How a light with a shape counts for a model: f of the specular part towards `specularL` times `specular`, and that of the
// diffuse part towards `diffuseL` times `irradiance`. The cosines are in both.
struct Arrival {
  vec3 specularL, diffuseL;
  float specular, irradiance;
  float widened;        // the alpha of D alone (Karis 2013, "Specular D modification"); 0: the surface's own
};

float spotProfile(PlacedLight light, vec3 L) {
  float x = clamp(-dot(light.along, L) * light.extent.x + light.extent.y, 0.0, 1.0);
  return x * x;
}

// Eq. 11 with its sign put right (physics.md K1): from the shaded point, the point of a sphere that is nearest to the ray.
vec3 nearestOfSphere(vec3 center, float radius, vec3 ray) {
  vec3 toRay = dot(center, ray) * ray - center;
  float distance = length(toRay);
  return center + toRay * (distance > radius ? radius / distance : 1.0);
}

// Eq. 19: the point of a segment that is nearest to the ray, from 0 at its start to 1.
float nearestOfSegment(vec3 start, vec3 along, vec3 ray) {
  float rayAlong = dot(ray, along), denominator = dot(along, along) - rayAlong * rayAlong;
  float t = (dot(ray, start) * rayAlong - dot(start, along)) / max(denominator, 1e-12);
  // A segment along the ray has no nearest point: its middle is as good as any.
  return denominator > 1e-6 * dot(along, along) ? clamp(t, 0.0, 1.0) : 0.5;
}

// Eq. 15, the irradiance of a line of points of 1 candela together, before any horizon.
float lineIrradiance(vec3 N, vec3 start, vec3 end) {
  float a = length(start), b = length(end);
  return max(dot(N, start) / a + dot(N, end) / b, 0.0) / max(a * b + dot(start, end), 1e-12);
}
// Of the part above the horizon, which is what arrives (physics.md K5).
float clippedLineIrradiance(vec3 N, vec3 start, vec3 end) {
  float a = dot(N, start), b = dot(N, end);
  if (max(a, b) <= 0.0) return 0.0;
  float share = 1.0;
  if (a < 0.0) { share = b / (b - a); start = end + (start - end) * share; }
  else if (b < 0.0) { share = a / (a - b); end = start + (end - start) * share; }
  return share * lineIrradiance(N, start, end);
}

// The irradiance of a sphere of radiance 1 over pi: the share of the sky that it takes, by cosine (Snyder 1996); `cosine`
// of its middle, `sine2` of the angle that its radius covers.
float sphereFormFactor(float cosine, float sine2) {
  if (cosine * cosine >= sine2) return max(cosine, 0.0) * sine2;
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0)), cut = sqrt(1.0 / max(sine2, 1e-9) - 1.0);
  float x = clamp(-cut * cosine / max(sine, 1e-6), -1.0, 1.0), y = sqrt(max(1.0 - x * x, 0.0)) * sine;
  // The two terms below nearly cancel when the sphere is small.
  float rest = sine2 < 1e-3 ? y * sqrt(sine2) * (1.0 - y * y / 3.0) : atan(y / max(cut, 1e-6)) / sine2 - cut * y;
  return max(cosine * acos(x) + rest, 0.0) * sine2 / kPi;
}

// Representative points (Karis 2013, p. 14 to 17), and how their lobes are made weaker: 1 the notes' eq. 10 with factor 3,
// 2 Unreal's factor 2, 3 widened in D alone, 4 not at all; others as 2.
Arrival representativePoint(PlacedLight light, Shading s, int method) {
  Arrival a;
  a.widened = 0.0;
  vec3 ray = 2.0 * dot(s.N, s.V) * s.N - s.V;
  float distance = length(light.center), factor = method == 1 || method == 3 ? 3.0 : 2.0, size = light.extent.x;
  vec3 towards = light.center / distance, point = light.center;
  float scale = 1.0;
  if (light.kind == kSphereLight) {
    point = nearestOfSphere(light.center, size, ray);
    float sine2 = min(size * size / (distance * distance), 1.0);
    a.specular = max(dot(s.N, towards), 0.0) / (distance * distance);
    a.irradiance = sphereFormFactor(dot(s.N, towards), sine2) / max(size * size, 1e-12);
  } else if (light.kind == kTubeLight) {
    vec3 along = 2.0 * light.along, start = light.center - light.along;
    point = nearestOfSphere(start + nearestOfSegment(start, along, ray) * along, size, ray);
    a.specular = lineIrradiance(s.N, start, start + along);
    a.irradiance = clippedLineIrradiance(s.N, start, start + along);
    scale = lineNormalization(s.alpha, widenedAlpha(s.alpha, length(along), distance, factor));
  } else if (light.kind == kRectangleLight) {
    // Where the ray meets its plane, or comes nearest to it, inside its edges.
    vec3 axis = normalize(cross(light.along, light.up));
    float facing = dot(ray, axis), t = dot(light.center, axis) / (abs(facing) > 1e-4 ? facing : 1e-4);
    vec3 across = (t > 0.0 ? t * ray : ray * distance) - light.center;
    point = light.center + clamp(dot(across, light.along) / dot(light.along, light.along), -1.0, 1.0) * light.along +
            clamp(dot(across, light.up) / dot(light.up, light.up), -1.0, 1.0) * light.up;
    // A lambertian emitter: of the same power, four times a point light's intensity straight ahead.
    float emitted = 4.0 * max(-dot(axis, towards), 0.0);
    a.specular = a.irradiance = emitted * max(dot(s.N, towards), 0.0) / (distance * distance);
    size = inversesqrt(light.extent.x);
  } else {
    a.specular = a.irradiance = spotProfile(light, towards) * max(dot(s.N, towards), 0.0) / (distance * distance);
    size = 0.0;
  }
  a.specularL = normalize(point);
  a.diffuseL = towards;
  float widened = widenedAlpha(s.alpha, size, distance, factor);
  if (method == 3) {
    a.specularL = towards;
    a.widened = light.kind == kTubeLight ? widenedAlpha(s.alpha, size + length(light.along), distance, factor) : widened;
  } else if (method != 4) {
    a.specular *= scale * sphereNormalization(s.alpha, widened);
  }
  return a;
}
