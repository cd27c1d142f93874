#include "app/editor/light_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// UI units: the aim's arrow, and how near to the middle a handle may come.
constexpr float kArrow = 64, kCone = 96, kLeastReach = 20;
constexpr float kFarthest = 1e4f;   // metres, of a light from the origin

float trackball(const HandleView& view) { return view.metres(0.36f * std::min(view.size.x, view.size.y) / view.scale, view.target); }

std::vector<glm::vec3> arc(glm::vec3 center, glm::vec3 x, glm::vec3 y, float from = 0, float to = 2 * kPi, int steps = 64) {
  std::vector<glm::vec3> points;
  for (int i = 0; i <= steps; ++i) {
    const float a = from + (to - from) * float(i) / float(steps);
    points.push_back(center + std::cos(a) * x + std::sin(a) * y);
  }
  return points;
}

// Across the axis and the line of sight, so that it is seen at full length.
glm::vec3 sideOf(glm::vec3 axis, glm::vec3 at, const HandleView& view) {
  const glm::vec3 side = glm::cross(axis, glm::normalize(view.eye - at));
  return glm::length(side) > 1e-3f ? glm::normalize(side) : view.right;
}

// The direction from `center` of a point on a ball that is rolled by the pointer; past the ball's edge it goes on over
// the other side.
glm::vec3 rolled(const HandleView& view, glm::vec3 center, float radius, glm::vec3 direction, glm::vec2 from, glm::vec2 to) {
  const glm::vec3 start = center + radius * direction;
  const auto seen = view.project(start);
  const float distance = glm::length(center - view.eye);
  if (!seen || distance <= radius) return direction;
  const glm::vec3 middle = (center - view.eye) / distance;
  const float rim = std::asin(radius / distance);
  glm::vec3 ray = view.ray(*seen + to - from);
  float angle = std::acos(std::clamp(glm::dot(ray, middle), -1.0f, 1.0f));
  bool far = glm::dot(direction, glm::normalize(start - view.eye)) > 0;
  if (angle > rim) {
    far = !far;
    angle = std::max(0.0f, 2 * rim - angle);
    ray = std::cos(angle) * middle + std::sin(angle) * glm::normalize(ray - middle * glm::dot(ray, middle));
  }
  const float reach = distance * std::sin(angle), half = std::sqrt(std::max(0.0f, radius * radius - reach * reach));
  return glm::normalize(view.eye + ray * (distance * std::cos(angle) + (far ? half : -half)) - center);
}

glm::vec3 moved(const HandleView& view, glm::vec3 start, glm::vec2 from, glm::vec2 to, bool oneAxis) {
  if (!oneAxis) return start + view.onPlane(to, start) - view.onPlane(from, start);
  // The axis that the drag runs along best, as it is seen.
  glm::vec3 best(0);
  float most = 0;
  const auto at = view.project(start);
  for (int i = 0; i < 3; ++i) {
    glm::vec3 axis(0);
    axis[i] = 1;
    const auto end = view.project(start + axis * view.metres(10, start));
    if (!at || !end) continue;
    const glm::vec2 seen = *end - *at;
    // One that points at the viewer moves far for little.
    if (glm::length(seen) < 2 * view.scale) continue;
    const float along = std::abs(glm::dot(glm::normalize(seen), to - from));
    if (along > most) {
      most = along;
      best = axis;
    }
  }
  if (most == 0) return start;
  const auto a = view.alongLine(from, start, best), b = view.alongLine(to, start, best);
  return a && b ? start + best * (*b - *a) : start;
}

// The angle from the axis at which the pointer is.
std::optional<float> angleAt(const Light& light, const HandleView& view, glm::vec2 pixel, float angle, float slant) {
  const glm::vec3 side = sideOf(light.axis, light.position, view), ray = view.ray(pixel);
  const auto hit = [&](glm::vec3 through, glm::vec3 normal) { return view.eye + ray * (glm::dot(through - view.eye, normal) / glm::dot(ray, normal)); };
  const glm::vec3 flat = glm::cross(light.axis, side);
  if (std::abs(glm::dot(ray, flat)) > 0.35f) {
    const glm::vec3 d = hit(light.position, flat) - light.position;
    return std::atan2(std::abs(glm::dot(d, side)), glm::dot(d, light.axis));
  }
  // Seen from before or behind: in the plane of the rim.
  if (std::abs(glm::dot(ray, light.axis)) < 1e-3f) return {};
  const float deep = std::max(slant * std::cos(angle), 0.05f * slant);
  const glm::vec3 middle = light.position + light.axis * deep;
  return std::atan2(glm::length(hit(middle, light.axis) - middle), deep);
}

glm::vec3 rim(const Light& light, const HandleView& view, float angle, float sign) {
  const float slant = view.metres(kCone, light.position);
  return light.position + slant * (std::cos(angle) * light.axis + std::sin(angle) * sign * sideOf(light.axis, light.position, view));
}

}  // namespace

HandleView::HandleView(const Camera& camera, glm::vec2 pixels, float uiScale)
    : eye(camera.eye), target(camera.target), size(pixels), scale(uiScale), focal_(pixels.y / (2 * std::tan(camera.fovY / 2))) {
  const glm::mat4 m = camera.viewFromWorld();
  right = {m[0][0], m[1][0], m[2][0]};
  up = {m[0][1], m[1][1], m[2][1]};
  forward = -glm::vec3(m[0][2], m[1][2], m[2][2]);
}

std::optional<glm::vec2> HandleView::project(glm::vec3 p) const {
  const glm::vec3 d = p - eye;
  const float depth = glm::dot(d, forward);
  if (!(depth > 1e-3f * glm::length(target - eye))) return {};
  return size / 2.0f + glm::vec2(glm::dot(d, right), -glm::dot(d, up)) * (focal_ / depth);
}

glm::vec3 HandleView::ray(glm::vec2 pixel) const {
  const glm::vec2 d = (pixel - size / 2.0f) / focal_;
  return glm::normalize(forward + right * d.x - up * d.y);
}

float HandleView::metres(float units, glm::vec3 at) const {
  const float least = 1e-3f * glm::length(target - eye);
  return units * scale * std::max(least, glm::dot(at - eye, forward)) / focal_;
}

glm::vec3 HandleView::onPlane(glm::vec2 pixel, glm::vec3 at) const {
  const glm::vec3 r = ray(pixel);
  return eye + r * (glm::dot(at - eye, forward) / glm::dot(r, forward));
}

std::optional<float> HandleView::alongLine(glm::vec2 pixel, glm::vec3 origin, glm::vec3 unit) const {
  const glm::vec3 r = ray(pixel), w = origin - eye;
  const float b = glm::dot(unit, r), across = 1 - b * b;
  if (across < 1e-3f) return {};
  return (b * glm::dot(r, w) - glm::dot(unit, w)) / across;
}

glm::vec2 HandleView::edge(glm::vec3 p, float inset) const {
  const glm::vec3 d = p - eye;
  glm::vec2 way(glm::dot(d, right), -glm::dot(d, up));
  if (glm::length(way) < 1e-6f) way = {0, 1};
  const glm::vec2 room = glm::max(size / 2.0f - inset * scale, glm::vec2(1));
  const glm::vec2 away = glm::abs(way);
  return size / 2.0f + way * std::min(room.x / std::max(away.x, 1e-9f), room.y / std::max(away.y, 1e-9f));
}

const char* name(LightGrip grip) {
  static constexpr const char* kNames[] = {"move", "aim", "size", "from", "to", "left", "right", "bottom", "top", "outer", "inner"};
  return kNames[int(grip)];
}

const char* stepLabel(LightGrip grip) {
  return grip == LightGrip::Move ? "Move light" : grip == LightGrip::Aim ? "Aim light" : "Size light";
}

std::vector<LightHandle> lightHandles(const Light& light, const HandleView& view) {
  if (light.kind == LightKind::Directional) return {{LightGrip::Aim, view.target + trackball(view) * light.direction}};
  const glm::vec3 at = light.position;
  std::vector<LightHandle> handles{{LightGrip::Move, at}};
  const auto reach = [&](float length) { return std::max(length, view.metres(kLeastReach, at)); };
  if (light.kind == LightKind::Sphere) handles.push_back({LightGrip::Size, at + reach(light.size) * glm::normalize(view.right + view.up)});
  if (light.kind == LightKind::Tube) {
    const float half = reach(light.length / 2);
    handles.push_back({LightGrip::From, at - half * light.axis});
    handles.push_back({LightGrip::To, at + half * light.axis});
    handles.push_back({LightGrip::Size, at + reach(light.size) * sideOf(light.axis, at, view)});
  }
  if (light.kind == LightKind::Rectangle) {
    glm::vec3 right, up;
    acrossAxis(light, right, up);
    const float x = reach(light.width / 2), y = reach(light.height / 2);
    handles.push_back({LightGrip::Left, at - x * right});
    handles.push_back({LightGrip::Right, at + x * right});
    handles.push_back({LightGrip::Bottom, at - y * up});
    handles.push_back({LightGrip::Top, at + y * up});
    handles.push_back({LightGrip::Aim, at + view.metres(kArrow, at) * light.axis});
  }
  if (light.kind == LightKind::Spot) {
    handles.push_back({LightGrip::Inner, rim(light, view, light.innerAngle, -1)});
    handles.push_back({LightGrip::Outer, rim(light, view, light.outerAngle, 1)});
    handles.push_back({LightGrip::Aim, at + view.metres(kCone + 14, at) * light.axis});
  }
  return handles;
}

std::vector<LightLine> lightOutline(const Light& light, const HandleView& view, bool selected) {
  std::vector<LightLine> lines;
  const glm::vec3 at = light.position;
  if (light.kind == LightKind::Directional) {
    const float radius = trackball(view);
    const glm::vec3 from = view.target + radius * light.direction;
    lines.push_back({{from - light.direction * view.metres(15, from), view.target + 0.5f * radius * light.direction}});
    if (selected) lines.push_back({arc(view.target, radius * view.right, radius * view.up), true});
  } else if (light.kind == LightKind::Sphere) {
    if (selected) lines.push_back({arc(at, {light.size, 0, 0}, {0, 0, light.size}), true});
    lines.push_back({arc(at, light.size * view.right, light.size * view.up)});
  } else if (light.kind == LightKind::Tube) {
    // The hull of two balls: a half circle around each end, joined.
    const glm::vec3 side = light.size * sideOf(light.axis, at, view), half = 0.5f * light.length * light.axis;
    const glm::vec3 out = light.size * glm::normalize(glm::cross(side / std::max(light.size, 1e-9f), glm::normalize(at - view.eye)));
    const glm::vec3 end = glm::dot(out, light.axis) < 0 ? -out : out;
    std::vector<glm::vec3> points = arc(at + half, side, end, 0, kPi, 24);
    const auto back = arc(at - half, side, end, kPi, 2 * kPi, 24);
    points.insert(points.end(), back.begin(), back.end());
    points.push_back(points.front());
    lines.push_back({points});
    lines.push_back({{at - half, at + half}, true});
  } else if (light.kind == LightKind::Rectangle) {
    glm::vec3 right, up;
    acrossAxis(light, right, up);
    const glm::vec3 x = 0.5f * light.width * right, y = 0.5f * light.height * up;
    lines.push_back({{at - x - y, at + x - y, at + x + y, at - x + y, at - x - y}});
    lines.push_back({{at, at + view.metres(kArrow, at) * light.axis}});
  } else if (light.kind == LightKind::Spot) {
    const float slant = view.metres(kCone, at);
    glm::vec3 x, y;
    acrossAxis(light, x, y);
    const auto circle = [&](float angle) {
      return arc(at + slant * std::cos(angle) * light.axis, slant * std::sin(angle) * x, slant * std::sin(angle) * y);
    };
    if (selected) lines.push_back({circle(light.innerAngle), true});
    lines.push_back({circle(light.outerAngle)});
    lines.push_back({{at, rim(light, view, light.outerAngle, 1)}});
    lines.push_back({{at, rim(light, view, light.outerAngle, -1)}});
    lines.push_back({{at, at + view.metres(kCone + 14, at) * light.axis}});
  }
  return lines;
}

Light dragged(const Light& start, LightGrip grip, const HandleView& view, glm::vec2 from, glm::vec2 to, bool oneAxis) {
  Light light = start;
  const glm::vec3 at = start.position;
  // How much farther out along a unit vector.
  const auto further = [&](glm::vec3 unit) {
    const auto a = view.alongLine(from, at, unit), b = view.alongLine(to, at, unit);
    return a && b ? *b - *a : 0.0f;
  };
  switch (grip) {
    case LightGrip::Move: light.position = moved(view, at, from, to, oneAxis); break;
    case LightGrip::Aim:
      if (start.kind == LightKind::Directional) light.direction = rolled(view, view.target, trackball(view), start.direction, from, to);
      else light.axis = rolled(view, at, view.metres(start.kind == LightKind::Spot ? kCone + 14 : kArrow, at), start.axis, from, to);
      break;
    case LightGrip::Size:
      if (start.kind == LightKind::Tube) light.size += further(sideOf(start.axis, at, view));
      else light.size += glm::length(view.onPlane(to, at) - at) - glm::length(view.onPlane(from, at) - at);
      light.size = std::clamp(light.size, 0.0f, kFarthest);
      break;
    case LightGrip::From:
    case LightGrip::To: {
      const glm::vec3 way = grip == LightGrip::To ? start.axis : -start.axis;
      const glm::vec3 end = at + 0.5f * start.length * way, other = at - 0.5f * start.length * way;
      if (oneAxis) {
        light.length = std::clamp(start.length + further(way), 0.0f, kFarthest);
        light.position = other + 0.5f * light.length * way;
        break;
      }
      const glm::vec3 now = moved(view, end, from, to, false);
      light.length = glm::length(now - other);
      light.position = 0.5f * (now + other);
      if (light.length > 1e-4f) light.axis = (grip == LightGrip::To ? now - other : other - now) / light.length;
      break;
    }
    case LightGrip::Left:
    case LightGrip::Right:
    case LightGrip::Bottom:
    case LightGrip::Top: {
      glm::vec3 right, up;
      acrossAxis(start, right, up);
      const bool across = grip == LightGrip::Left || grip == LightGrip::Right;
      const float sign = grip == LightGrip::Right || grip == LightGrip::Top ? 1.0f : -1.0f;
      float& side = across ? light.width : light.height;
      side = std::clamp(side + 2 * further(sign * (across ? right : up)), 0.0f, kFarthest);
      break;
    }
    case LightGrip::Outer:
    case LightGrip::Inner: {
      const bool outer = grip == LightGrip::Outer;
      float& angle = outer ? light.outerAngle : light.innerAngle;
      const auto grabbed = view.project(rim(start, view, angle, outer ? 1.0f : -1.0f));
      if (!grabbed) break;
      if (const auto now = angleAt(start, view, *grabbed + to - from, angle, view.metres(kCone, at))) angle = std::clamp(*now, 0.0f, 0.5f * kPi);
      light.innerAngle = std::min(light.innerAngle, light.outerAngle);
      break;
    }
  }
  light.position = glm::clamp(light.position, -kFarthest, kFarthest);
  return isSound(light) ? light : start;
}

Light placedBeside(const Light& light, const HandleView& view) {
  Light copy = light;
  const glm::vec2 middle = view.size / 2.0f;
  const glm::vec2 aside(36 * view.scale, 0);
  return dragged(copy, light.kind == LightKind::Directional ? LightGrip::Aim : LightGrip::Move, view, middle, middle + aside);
}

float distanceToSee(const std::vector<Light>& lights, Camera camera, glm::vec2 size, float least) {
  const glm::vec3 away = glm::normalize(camera.eye - camera.target);
  const glm::vec2 margin = 0.06f * size;
  float distance = least;
  for (int i = 0; i < 200; ++i, distance *= 1.06f) {
    camera.eye = camera.target + distance * away;
    const HandleView view(camera, size, 1);
    const auto seen = [&](const Light& light) {
      if (light.kind == LightKind::Directional || !isSound(light)) return true;
      const auto at = view.project(light.position);
      return at && glm::all(glm::greaterThan(*at, margin)) && glm::all(glm::lessThan(*at, size - margin));
    };
    if (std::all_of(lights.begin(), lights.end(), seen)) break;
  }
  return distance;
}

std::string lightIntensity(const Light& light) {
  if (light.kind == LightKind::Directional) return fmt::format("{:.3g} lx", light.lux);
  return fmt::format("{:.4g} lm \u00b7 {:.3g} cd", light.candela * lumensPerCandela(light), light.candela);
}

std::string gripText(const Light& light, LightGrip grip) {
  switch (grip) {
    case LightGrip::Move: return fmt::format("{:.2f}  {:.2f}  {:.2f} m", light.position.x, light.position.y, light.position.z);
    case LightGrip::Aim: {
      const glm::vec3 d = light.kind == LightKind::Directional ? light.direction : light.axis;
      return fmt::format("height {:.0f}\u00b0  side {:.0f}\u00b0", glm::degrees(std::asin(std::clamp(d.y, -1.0f, 1.0f))), glm::degrees(std::atan2(d.x, d.z)));
    }
    case LightGrip::Size: return fmt::format("radius {:.3g} m", light.size);
    case LightGrip::From:
    case LightGrip::To: return fmt::format("length {:.2f} m", light.length);
    case LightGrip::Left:
    case LightGrip::Right: return fmt::format("width {:.2f} m", light.width);
    case LightGrip::Bottom:
    case LightGrip::Top: return fmt::format("height {:.2f} m", light.height);
    case LightGrip::Outer: return fmt::format("outer {:.0f}\u00b0", glm::degrees(light.outerAngle));
    case LightGrip::Inner: return fmt::format("inner {:.0f}\u00b0", glm::degrees(light.innerAngle));
  }
  return {};
}

}  // namespace glint
