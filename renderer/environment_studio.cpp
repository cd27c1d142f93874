// "studio": a photographer's studio with softboxes, made from a short list of lights. It is the first thing that
// everyone sees reflected, so it is built like the real thing: boxes with hot centres and soft edges, dark
// warm walls, and a floor that the boxes light.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/environment.h"
#include "renderer/parallel.h"

namespace glint {
namespace {

// A rectangular diffuser that faces the middle of the studio.
struct Softbox {
  glm::vec3 center;      // where it hangs, metres
  glm::vec2 half;        // half its width and height, metres
  float roll;            // about its own axis, radians
  glm::vec3 color;       // nits at its centre
  float falloff;         // e^-falloff of that at the middle of its sides
  float corner = 0.12f;  // radius of its rounded corners, metres
  float edge = 0.10f;    // width of the soft edge, metres

  // Made by prepare().
  glm::vec3 normal{0}, right{0}, up{0};

  void prepare() {
    normal = -glm::normalize(center);
    const glm::vec3 level = std::abs(normal.y) > 0.95f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    const glm::vec3 side = glm::normalize(glm::cross(level, normal)), high = glm::cross(normal, side);
    right = side * std::cos(roll) + high * std::sin(roll);
    up = high * std::cos(roll) - side * std::sin(roll);
  }

  // 0..1 at a point of its plane: one inside, soft across the edge, dimmer away from the centre.
  float shape(glm::vec2 p) const {
    const glm::vec2 q = glm::abs(p) - half + corner;
    const float outside = glm::length(glm::max(q, glm::vec2(0))) + std::min(std::max(q.x, q.y), 0.0f) - corner;
    const float t = glm::clamp(0.5f - outside / edge, 0.0f, 1.0f);
    if (t == 0) return 0;
    const glm::vec2 n = p / half;
    return t * t * (3 - 2 * t) * std::exp(-falloff * glm::dot(n, n));
  }
  // The light that comes from `direction` of this box, seen from the middle of the studio.
  glm::vec3 seen(const glm::vec3& direction) const {
    const float facing = -glm::dot(direction, normal);
    if (facing <= 0.05f) return glm::vec3(0);
    const glm::vec3 p = direction * (glm::length(center) / facing) - center;
    const float s = shape({glm::dot(p, right), glm::dot(p, up)});
    return s > 0 ? color * s : glm::vec3(0);
  }
  // The irradiance at a point of a floor that faces up, the box taken as a small source.
  glm::vec3 onFloor(const glm::vec3& point) const {
    const glm::vec3 to = center - point;
    const float distance2 = glm::dot(to, to);
    const float cosines = std::max(to.y, 0.0f) * std::max(-glm::dot(to, normal), 0.0f) / distance2;
    const float area = 4 * half.x * half.y, mean = 1 / (1 + 0.75f * falloff);
    return color * (mean * area * cosines / (distance2 + area / glm::pi<float>()));
  }
};

glm::vec3 at(float azimuth, float elevation, float distance) {
  // Azimuth in degrees from +Z, where the viewer is, to the right.
  const float a = glm::radians(azimuth), e = glm::radians(elevation);
  return distance * glm::vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
}

// Sets all boxes together: a white surface towards the key shows about 0.8.
constexpr float kPower = 1.22f;

std::array<Softbox, 7> softboxes() {
  std::array<Softbox, 7> boxes{{
      // Key: large, warm, from the upper left.
      {at(-46, 38, 3.0f), {1.25f, 1.05f}, 0.10f, {6.3f, 5.95f, 5.45f}, 1.25f, 0.16f, 0.22f},
      // Fill: a tall strip on the right, cool.
      {at(62, 14, 3.0f), {0.36f, 1.45f}, 0.04f, {3.1f, 3.3f, 3.6f}, 1.15f, 0.12f, 0.16f},
      // A narrow strip beside it draws a crisp line into polished metal.
      {at(88, 16, 3.0f), {0.10f, 1.25f}, 0.04f, {4.0f, 4.2f, 4.5f}, 0.90f, 0.06f, 0.07f},
      // Rims: from behind on both sides.
      {at(-116, 22, 3.2f), {0.42f, 1.40f}, -0.06f, {5.6f, 5.4f, 5.0f}, 1.10f, 0.12f, 0.16f},
      {at(146, 26, 3.2f), {0.80f, 0.60f}, 0.10f, {3.6f, 3.75f, 4.0f}, 1.20f, 0.14f, 0.18f},
      // Overhead bank, a little behind the subject.
      {at(180, 72, 2.8f), {1.40f, 0.60f}, 0.0f, {4.2f, 4.1f, 3.9f}, 1.15f, 0.16f, 0.22f},
      // A faint reflector low in front opens the shadows.
      {at(22, -16, 3.0f), {1.00f, 0.50f}, 0.0f, {0.40f, 0.375f, 0.345f}, 1.60f, 0.22f, 0.60f},
  }};
  for (Softbox& box : boxes) {
    box.color *= kPower;
    box.prepare();
  }
  return boxes;
}

// The walls: warm dark grey, lighter low down where the floor bounces, darker towards the ceiling.
glm::vec3 wall(const glm::vec3& d) {
  const glm::vec3 warm{0.088f, 0.081f, 0.074f};
  const float height = glm::clamp(d.y, 0.0f, 1.0f);
  const float rise = std::exp(-3.2f * height);
  // A lit backdrop behind the subject, so that outlines have something to stand against.
  const float behind = std::max(0.0f, -d.z), glow = behind * behind * behind * std::exp(-5.0f * height * height);
  return warm * (0.42f + 0.85f * rise) + glm::vec3(0.130f, 0.127f, 0.124f) * glow;
}

}  // namespace

ImageF studioPixels(int width) {
  GLINT_CHECK(width >= 2 && width % 2 == 0, "{}", width);
  const auto boxes = softboxes();
  constexpr float kFloor = -1.25f;  // metres below the middle
  const glm::vec3 albedo{0.225f, 0.212f, 0.197f};
  ImageF image(width, width / 2, 3);
  parallelFor(size_t(image.height), [&](size_t row) {
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3 d = environmentDirection(x, int(row), image.width, image.height);
      glm::vec3 light = wall(d);
      if (d.y < 0) {
        // The floor, faded into the wall at the horizon as a curved backdrop does.
        const glm::vec3 point = d * (kFloor / std::min(d.y, -0.02f));
        glm::vec3 irradiance(0.55f, 0.52f, 0.49f);
        for (const Softbox& box : boxes) irradiance += box.onFloor(point);
        // The subject stands in its own light.
        irradiance *= 1 - 0.6f * std::exp(-(point.x * point.x + point.z * point.z) / 0.8f);
        const float t = glm::clamp(-d.y / 0.30f, 0.0f, 1.0f);
        light = glm::mix(light, albedo * irradiance / glm::pi<float>(), t * t * (3 - 2 * t));
      }
      for (const Softbox& box : boxes) light = glm::max(light, box.seen(d));
      float* out = image.at(x, int(row));
      for (int c = 0; c < 3; ++c) out[c] = light[c];
    }
  });
  return image;
}

}  // namespace glint
