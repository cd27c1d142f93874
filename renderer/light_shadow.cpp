#include "renderer/light_shadow.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>

namespace glint {
namespace {

constexpr float kLargestSource = 0.35f;   // half its size over its distance: no single map tells what a larger one sees
constexpr float kWidestCone = 1.3f;   // radians from a map's axis: wider ones would spend their texels on the rim

struct Axes {
  glm::vec3 x, y, z;                  // z towards the light
};
Axes axesAlong(glm::vec3 z) {
  const glm::vec3 x = glm::normalize(glm::cross(std::abs(z.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0), z));
  return {x, glm::cross(z, x), z};
}
glm::mat4 mapAxesFromWorld(const Axes& a, glm::vec3 origin) {
  glm::mat4 m(1);
  for (int i = 0; i < 3; ++i) {
    m[i][0] = a.x[i];
    m[i][1] = a.y[i];
    m[i][2] = a.z[i];
  }
  for (int i = 0; i < 3; ++i) m[3][i] = -glm::dot(i == 0 ? a.x : i == 1 ? a.y : a.z, origin);
  return m;
}
const glm::mat4 kUnitFromClip(0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0.5f, 0.5f, 0.5f, 1);

template <class Visit>
void eachCorner(const CasterBounds& box, const Visit& visit) {
  for (int i = 0; i < 8; ++i) visit(glm::vec3(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z));
}

// The half axes of a source, metres: of the same area as a disc with them.
void sourceAxes(const Light& light, const Axes& map, glm::vec3& u, glm::vec3& v) {
  u = map.x * light.size;
  v = map.y * light.size;
  if (light.kind == LightKind::Point) u = v = glm::vec3(0);
  if (light.kind == LightKind::Rectangle) {
    constexpr float kDiscOfSquare = 1.1283792f;   // 2 / sqrt(pi)
    glm::vec3 right, up;
    acrossAxis(light, right, up);
    u = right * (0.5f * light.width * kDiscOfSquare);
    v = up * (0.5f * light.height * kDiscOfSquare);
  }
  if (light.kind == LightKind::Tube) {
    u = light.axis * (0.5f * light.length + light.size);
    const glm::vec3 side = glm::cross(light.axis, map.z);
    if (glm::dot(side, side) > 1e-6f) v = glm::normalize(side) * light.size;
  }
}

ShadowView directional(const Light& light, const CasterBounds& box, int side) {
  const Axes axes = axesAlong(glm::normalize(light.direction));
  glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
  eachCorner(box, [&](glm::vec3 corner) {
    const glm::vec3 p(glm::dot(corner, axes.x), glm::dot(corner, axes.y), glm::dot(corner, axes.z));
    low = glm::min(low, p);
    high = glm::max(high, p);
  });
  // Room for a texel or two around, and for rounding along the depth.
  const float least = std::max(1e-3f * box.radius(), 1e-6f);
  const glm::vec3 margin = (high - low) * (2.0f / static_cast<float>(side)) + least;
  low -= margin;
  high += margin;
  const glm::mat4 clip = glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z);
  ShadowView view;
  view.mapFromWorld = kUnitFromClip * clip * mapAxesFromWorld(axes, glm::vec3(0));
  const float slope = std::tan(0.5f * light.angle) * (high.z - low.z);
  view.source = {slope / (high.x - low.x), 0, 0, slope / (high.y - low.y)};
  view.towards = glm::vec4(axes.z, 0);
  view.texel = std::max(high.x - low.x, high.y - low.y) / static_cast<float>(side);
  view.sine = std::sin(0.5f * light.angle);
  return view;
}

std::optional<ShadowView> placed(const Light& light, const CasterBounds& box, int side) {
  const glm::vec3 toCenter = box.center() - light.position;
  const float distance = glm::length(toCenter), radius = box.radius();
  // Outside of the casters' sphere the map needs to look at that alone; a spot may be narrower, or have a cone where others have none.
  const float around = distance > radius ? std::asin(radius / distance) : 2 * kWidestCone;
  const bool cone = light.kind == LightKind::Spot && std::min(light.outerAngle, kWidestCone) < around;
  if (!cone && around > kWidestCone) return std::nullopt;
  const Axes axes = axesAlong(-glm::normalize(cone ? light.axis : toCenter));
  glm::vec2 low(std::numeric_limits<float>::max()), high = -low;
  float nearest = std::numeric_limits<float>::max(), farthest = 0;
  eachCorner(box, [&](glm::vec3 corner) {
    const glm::vec3 p = corner - light.position;
    const float depth = -glm::dot(p, axes.z);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    if (depth <= 0) return;
    const glm::vec2 tangent = glm::vec2(glm::dot(p, axes.x), glm::dot(p, axes.y)) / depth;
    low = glm::min(low, tangent);
    high = glm::max(high, tangent);
  });
  if (farthest <= 0) return std::nullopt;   // all behind it
  const float widest = std::tan(cone ? std::min(light.outerAngle, kWidestCone) : kWidestCone);
  // With corners behind the light its outline there says nothing.
  if (nearest <= 0) low = glm::vec2(-widest), high = glm::vec2(widest);
  low = glm::max(low, glm::vec2(-widest));
  high = glm::min(high, glm::vec2(widest));
  if (high.x - low.x < 1e-6f || high.y - low.y < 1e-6f) return std::nullopt;   // none in the cone
  const glm::vec2 margin = (high - low) * (2.0f / static_cast<float>(side)) + 1e-5f;
  low -= margin;
  high += margin;
  const float f = farthest * 1.001f, n = std::max(nearest * 0.999f, 2e-3f * f);
  ShadowView view;
  view.mapFromWorld = kUnitFromClip * glm::frustum(low.x * n, high.x * n, low.y * n, high.y * n, n, f) * mapAxesFromWorld(axes, light.position);
  glm::vec3 u, v;
  sourceAxes(light, axes, u, v);
  for (glm::vec3* half : {&u, &v})
    if (const float length = glm::length(*half), most = kLargestSource * distance; length > most) *half *= most / length;
  const glm::vec2 scale = (f - n) / (f * n) / (high - low);
  view.source = {glm::dot(u, axes.x) * scale.x, glm::dot(u, axes.y) * scale.y, glm::dot(v, axes.x) * scale.x, glm::dot(v, axes.y) * scale.y};
  view.towards = glm::vec4(light.position, 1);
  view.texel = std::max(high.x - low.x, high.y - low.y) / static_cast<float>(side);
  view.sine = std::min(std::max(glm::length(u), glm::length(v)) / std::max(distance - radius, 0.5f * distance), 0.5f);
  return view;
}

float brightness(const Light& light, glm::vec3 at) {
  const float color = std::max(light.color.r, std::max(light.color.g, light.color.b));
  if (light.kind == LightKind::Directional) return color * light.lux;
  const glm::vec3 d = light.position - at;
  return color * light.candela / std::max(glm::dot(d, d) + light.constant, 1e-12f);
}

std::string namesOf(const std::vector<std::string>& names) {
  constexpr size_t kMostNames = 6;
  const std::vector<std::string> first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kMostNames)));
  std::string text = fmt::format("{}", fmt::join(first, ", "));
  if (names.size() > kMostNames) text += fmt::format(" and {} more", names.size() - kMostNames);
  return text;
}

}  // namespace

void CasterBounds::add(glm::vec3 point) {
  const bool first = empty();
  low = first ? point : glm::min(low, point);
  high = first ? point : glm::max(high, point);
}

std::optional<ShadowView> shadowView(const Light& light, const CasterBounds& box, int side) {
  if (box.empty() || !isSound(light)) return std::nullopt;
  return light.kind == LightKind::Directional ? directional(light, box, side) : placed(light, box, side);
}

std::vector<int> shadowNumbers(std::span<const Light> lights, const CasterBounds& box, Diagnostics& problems) {
  std::vector<int> numbers(lights.size());
  if (box.empty()) return numbers;
  std::vector<size_t> order;
  std::vector<std::string> among, beyond;
  const auto name = [&](size_t i) { return fmt::format("{} light {}", infoOf(lights[i].kind).id, i + 1); };
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (!light.shadow || !isSound(light) || brightness(light, box.center()) <= 0) continue;
    if (shadowView(light, box, kShadowMapSide)) order.push_back(i);
    else if (light.kind != LightKind::Spot) among.push_back(name(i));   // a spot that sees no caster needs no map
  }
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return brightness(lights[a], box.center()) > brightness(lights[b], box.center()); });
  for (size_t i = 0; i < order.size(); ++i) {
    if (i < static_cast<size_t>(kMostShadows)) numbers[order[i]] = static_cast<int>(i) + 1;
    else beyond.push_back(name(order[i]));
  }
  if (!among.empty())
    problems.push_back(warning("shadows", fmt::format("no shadow of {}", namesOf(among)), "it stands too near to the surfaces for one map: move it out, or make it a spot"));
  if (!beyond.empty())
    problems.push_back(warning("shadows", fmt::format("no shadow of {}", namesOf(beyond)), fmt::format("a view has at most {}: turn off those of weaker lights (shadow=off)", kMostShadows)));
  return numbers;
}

}  // namespace glint
