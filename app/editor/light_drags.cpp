// What dragging the handles of a light does to it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "app/editor/light_handle_places.h"
#include "app/editor/light_handles.h"

namespace glint {

using namespace handle_places;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kFarthest = 1e4f;                      // metres, of a light from the origin
constexpr float kLeastRange = 1e-3f, kSnapDegrees = 5, kSnapUnits = 8;

// 1, 2 or 5 of some power of ten: the first that is not less.
float roundStep(float least) {
  const float power = std::pow(10.0f, std::floor(std::log10(std::max(least, 1e-6f))));
  for (const float digit : {1.0f, 2.0f, 5.0f})
    if (digit * power >= least * 0.999f) return digit * power;
  return 10 * power;
}
float toStep(float value, float step) { return std::round(value / step) * step; }

glm::vec3 snappedDirection(glm::vec3 d) {
  const float step = glm::radians(kSnapDegrees);
  const float height = toStep(std::asin(std::clamp(d.y, -1.0f, 1.0f)), step), side = toStep(std::atan2(d.x, d.z), step);
  return glm::normalize(glm::vec3(std::cos(height) * std::sin(side), std::sin(height), std::cos(height) * std::cos(side)));
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

// The world's axis that the drag runs along best, as it is seen; -1: none.
int axisAlong(const HandleView& view, glm::vec3 start, glm::vec2 way) {
  int best = -1;
  float most = 0;
  const auto at = view.project(start);
  for (int i = 0; i < 3; ++i) {
    const auto end = view.project(start + worldAxis(i) * view.metres(10, start));
    if (!at || !end) continue;
    const glm::vec2 seen = *end - *at;
    // One that points at the viewer moves far for little.
    if (glm::length(seen) < 2 * view.scale) continue;
    const float along = std::abs(glm::dot(glm::normalize(seen), way));
    if (along > most) {
      most = along;
      best = i;
    }
  }
  return best;
}

// A point that is moved, as the grip wants it: along an axis, in a plane, or as the camera faces it.
glm::vec3 moved(const HandleView& view, glm::vec3 start, const LightDrag& drag) {
  int axis = axisOf(drag.grip);
  const int plane = planeOf(drag.grip);
  if (axis < 0 && plane < 0 && drag.straight) axis = axisAlong(view, start, drag.to - drag.from);
  glm::vec3 now = start;
  if (axis >= 0) {
    const auto a = view.alongLine(drag.from, start, worldAxis(axis)), b = view.alongLine(drag.to, start, worldAxis(axis));
    if (a && b) now[axis] += *b - *a;
  } else if (plane >= 0) {
    const auto a = view.onPlane(drag.from, start, worldAxis(plane)), b = view.onPlane(drag.to, start, worldAxis(plane));
    if (a && b) now += *b - *a;
    now[plane] = start[plane];
  } else if (!drag.straight) {
    now += view.onPlane(drag.to, start) - view.onPlane(drag.from, start);
  }
  if (drag.snap) {
    const float step = roundStep(view.metres(kSnapUnits, start));
    for (int i = 0; i < 3; ++i)
      if (now[i] != start[i]) now[i] = toStep(now[i], step);
  }
  return now;
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

glm::vec3 aimPoint(const Light& start, const HandleView& view, const LightDrag& drag) {
  if (drag.surface) return *drag.surface;
  const glm::vec3 aim = start.position + drag.aim * start.axis;
  return aim + view.onPlane(drag.to, aim) - view.onPlane(drag.from, aim);
}

// How many times as far from `at` the pointer is as it was at `from`.
float ratio(const HandleView& view, glm::vec3 at, glm::vec2 from, glm::vec2 to) {
  const auto middle = view.project(at);
  if (!middle) return 1;
  return glm::length(to - *middle) / std::max(glm::length(from - *middle), 8 * view.scale);
}

void scale(Light& light, float factor) {
  const auto times = [&](float& value, float least = 0) { value = std::clamp(value * factor, least, kFarthest); };
  switch (light.kind) {
    case LightKind::Directional: light.angle = std::clamp(light.angle * factor, 0.0f, kPi / 6); break;
    case LightKind::Point: times(light.radius, kLeastRange); break;
    case LightKind::Spot: {
      const float before = light.outerAngle;
      light.outerAngle = std::clamp(before * factor, 0.0f, 0.5f * kPi);
      if (before > 0) light.innerAngle *= light.outerAngle / before;
      break;
    }
    case LightKind::Sphere: times(light.size); break;
    case LightKind::Tube: times(light.size), times(light.length); break;
    case LightKind::Rectangle: times(light.width), times(light.height); break;
  }
}

}  // namespace

float draggedAim(const Light& start, const HandleView& view, const LightDrag& drag) { return glm::length(aimPoint(start, view, drag) - start.position); }

Light aimedAt(const Light& light, glm::vec3 point) {
  Light aimed = light;
  const glm::vec3 way = point - light.position;
  if (glm::length(way) > 1e-5f) aimed.axis = glm::normalize(way);
  return isSound(aimed) ? aimed : light;
}

Light highlighting(const Light& light, const HandleView& view, glm::vec3 point, glm::vec3 normal) {
  const glm::vec3 seen = glm::normalize(point - view.eye), way = glm::normalize(glm::reflect(seen, normal));
  Light placed = light;
  if (light.kind == LightKind::Directional) {
    placed.direction = way;
  } else {
    placed.position = point + way * glm::length(light.position - point);
    if (light.kind != LightKind::Tube) placed.axis = -way;
  }
  return isSound(placed) ? placed : light;
}

Light dragged(const Light& start, const HandleView& view, const LightDrag& drag) {
  Light light = start;
  const glm::vec3 at = start.position;
  const auto [grip, from, to] = std::tuple(drag.grip, drag.from, drag.to);
  // How much farther out along a unit vector.
  const auto further = [&](glm::vec3 unit) {
    const auto a = view.alongLine(from, at, unit), b = view.alongLine(to, at, unit);
    return a && b ? *b - *a : 0.0f;
  };
  const auto length = [&](float value, float least = 0.0f) {
    if (drag.snap) value = toStep(value, roundStep(view.metres(kSnapUnits, at)));
    return std::clamp(value, least, kFarthest);
  };
  const auto angle = [&](float value) {
    if (drag.snap) value = toStep(value, glm::radians(kSnapDegrees));
    return std::clamp(value, 0.0f, 0.5f * kPi);
  };
  switch (grip) {
    case LightGrip::Move:
    case LightGrip::AxisX:
    case LightGrip::AxisY:
    case LightGrip::AxisZ:
    case LightGrip::PlaneX:
    case LightGrip::PlaneY:
    case LightGrip::PlaneZ: light.position = moved(view, at, drag); break;
    case LightGrip::Aim:
      if (start.kind == LightKind::Directional) light.direction = rolled(view, view.target, sunBall(view), start.direction, from, to);
      else light = aimedAt(start, aimPoint(start, view, drag));
      break;
    case LightGrip::Turn: light.axis = rolled(view, at, arrowLength(start, view), start.axis, from, to); break;
    case LightGrip::Size:
      if (start.kind == LightKind::Tube) light.size += further(sideOf(start.axis, at, view));
      else light.size += glm::length(view.onPlane(to, at) - at) - glm::length(view.onPlane(from, at) - at);
      light.size = length(light.size);
      break;
    case LightGrip::From:
    case LightGrip::To: {
      const glm::vec3 way = grip == LightGrip::To ? start.axis : -start.axis;
      const glm::vec3 end = at + 0.5f * start.length * way, other = at - 0.5f * start.length * way;
      if (drag.straight) {
        light.length = length(start.length + further(way));
        light.position = other + 0.5f * light.length * way;
        break;
      }
      const glm::vec3 now = moved(view, end, drag);
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
      side = length(side + 2 * further(sign * (across ? right : up)));
      break;
    }
    case LightGrip::Outer:
    case LightGrip::Inner: {
      const bool outer = grip == LightGrip::Outer;
      float& which = outer ? light.outerAngle : light.innerAngle;
      const auto grabbed = view.project(rim(start, view, which, outer ? 1.0f : -1.0f));
      if (!grabbed) break;
      if (const auto now = angleAt(start, view, *grabbed + to - from, which, view.metres(kCone, at))) which = angle(*now);
      // Each pushes the other.
      if (outer) light.innerAngle = std::min(light.innerAngle, light.outerAngle);
      else light.outerAngle = std::max(light.innerAngle, light.outerAngle);
      break;
    }
    case LightGrip::Reach: light.radius = length(start.radius * ratio(view, at, from, to), kLeastRange); break;
    case LightGrip::Scale: scale(light, ratio(view, start.kind == LightKind::Directional ? view.target : at, from, to)); break;
  }
  if (drag.snap && (grip == LightGrip::Aim || grip == LightGrip::Turn)) {
    glm::vec3& way = start.kind == LightKind::Directional ? light.direction : light.axis;
    way = snappedDirection(way);
  }
  light.position = glm::clamp(light.position, -kFarthest, kFarthest);
  return isSound(light) ? light : start;
}

Light placedBeside(const Light& light, const HandleView& view) {
  const glm::vec2 middle = view.size / 2.0f;
  return dragged(light, view, {.grip = wholeGrip(light), .from = middle, .to = middle + glm::vec2(36 * view.scale, 0)});
}

}  // namespace glint
