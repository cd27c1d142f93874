#include "app/editor/light_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/light_handle_places.h"

namespace glint {
namespace handle_places {

float sunBall(const HandleView& view) { return view.metres(0.36f * std::min(view.size.x, view.size.y) / view.scale, view.target); }

glm::vec3 worldAxis(int i) {
  glm::vec3 axis(0);
  axis[i] = 1;
  return axis;
}

glm::vec3 sideOf(glm::vec3 axis, glm::vec3 at, const HandleView& view) {
  const glm::vec3 away = view.eye - at;
  const glm::vec3 side = glm::length(away) > 0 ? glm::cross(axis, glm::normalize(away)) : glm::vec3(0);
  return glm::length(side) > 1e-3f ? glm::normalize(side) : view.right;
}

glm::vec3 rim(const Light& light, const HandleView& view, float angle, float sign) {
  const float slant = view.metres(kCone, light.position);
  return light.position + slant * (std::cos(angle) * light.axis + std::sin(angle) * sign * sideOf(light.axis, light.position, view));
}

float arrowLength(const Light& light, const HandleView& view) { return view.metres(light.kind == LightKind::Spot ? kConeArrow : kArrow, light.position); }

glm::vec3 reachHandle(const Light& light, const HandleView& view) {
  const glm::vec3 way = -glm::normalize(view.right + view.up), end = light.position + light.radius * way;
  const auto seen = view.project(end);
  if (seen && view.inside(*seen, 12)) return end;
  return light.position + std::min(light.radius, view.metres(kFarReach, light.position)) * way;
}

}  // namespace handle_places

using namespace handle_places;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

std::vector<glm::vec3> arc(glm::vec3 center, glm::vec3 x, glm::vec3 y, float from = 0, float to = 2 * kPi, int steps = 64) {
  std::vector<glm::vec3> points;
  for (int i = 0; i <= steps; ++i) {
    const float a = from + (to - from) * float(i) / float(steps);
    points.push_back(center + std::cos(a) * x + std::sin(a) * y);
  }
  return points;
}

// Where two points are in the picture, from one to the other; nothing when one is not before the eye.
std::optional<glm::vec2> seenWay(const HandleView& view, glm::vec3 a, glm::vec3 b) {
  const auto p = view.project(a), q = view.project(b);
  if (!p || !q) return {};
  return *q - *p;
}

void addAxes(std::vector<LightHandle>& handles, glm::vec3 at, const HandleView& view) {
  const float one = view.metres(1, at);
  std::optional<glm::vec2> seen[3];
  for (int i = 0; i < 3; ++i) {
    seen[i] = seenWay(view, at, at + one * kAxis * worldAxis(i));
    // One that points at the viewer says nothing and cannot be dragged.
    if (seen[i] && glm::length(*seen[i]) > 16 * view.scale) handles.push_back({LightGrip(int(LightGrip::AxisX) + i), at + one * kAxis * worldAxis(i)});
  }
  for (int i = 0; i < 3; ++i) {
    const auto &u = seen[(i + 1) % 3], &v = seen[(i + 2) % 3];
    if (!u || !v || std::abs(u->x * v->y - u->y * v->x) < 0.28f * kAxis * kAxis * view.scale * view.scale) continue;
    const float middle = 0.5f * (kPlaneFrom + kPlaneTo) * one;
    handles.push_back({LightGrip(int(LightGrip::PlaneX) + i), at + middle * (worldAxis((i + 1) % 3) + worldAxis((i + 2) % 3))});
  }
}

}  // namespace

const char* name(LightGrip grip) {
  static constexpr const char* kNames[] = {"move", "axis x", "axis y", "axis z", "plane x", "plane y", "plane z", "aim", "turn", "size",
                                           "from", "to", "left", "right", "bottom", "top", "outer", "inner", "reach", "scale"};
  return kNames[int(grip)];
}

int axisOf(LightGrip grip) { return grip >= LightGrip::AxisX && grip <= LightGrip::AxisZ ? int(grip) - int(LightGrip::AxisX) : -1; }
int planeOf(LightGrip grip) { return grip >= LightGrip::PlaneX && grip <= LightGrip::PlaneZ ? int(grip) - int(LightGrip::PlaneX) : -1; }
LightGrip wholeGrip(const Light& light) { return light.kind == LightKind::Directional ? LightGrip::Aim : LightGrip::Move; }

const char* stepLabel(LightGrip grip) {
  if (grip <= LightGrip::PlaneZ) return "Move light";
  return grip == LightGrip::Aim || grip == LightGrip::Turn ? "Aim light" : "Size light";
}

float aimDistance(const Light& light, const HandleView& view) {
  const glm::vec3 to = view.target - light.position;
  const float along = glm::dot(to, light.axis), far = glm::length(to);
  return std::max(along > 0.3f * far ? along : far, 1.3f * arrowLength(light, view));
}

std::vector<LightHandle> lightHandles(const Light& light, const HandleView& view, float aim) {
  if (light.kind == LightKind::Directional) return {{LightGrip::Aim, view.target + sunBall(view) * light.direction}};
  const glm::vec3 at = light.position;
  std::vector<LightHandle> handles{{LightGrip::Move, at}};
  const auto reach = [&](float length) { return std::max(length, view.metres(kLeastReach, at)); };
  if (light.kind == LightKind::Sphere) handles.push_back({LightGrip::Size, at + reach(light.size) * glm::normalize(0.4f * view.up - view.right)});
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
  }
  if (light.kind == LightKind::Spot) {
    handles.push_back({LightGrip::Inner, rim(light, view, light.innerAngle, -1)});
    handles.push_back({LightGrip::Outer, rim(light, view, light.outerAngle, 1)});
  }
  if (light.kind == LightKind::Spot || light.kind == LightKind::Rectangle) {
    handles.push_back({LightGrip::Turn, at + arrowLength(light, view) * light.axis});
    const auto apart = seenWay(view, handles.back().at, at + aim * light.axis);
    if (aim > 0 && apart && glm::length(*apart) > 20 * view.scale) handles.push_back({LightGrip::Aim, at + aim * light.axis});
  }
  handles.push_back({LightGrip::Reach, reachHandle(light, view)});
  addAxes(handles, at, view);
  return handles;
}

std::vector<glm::vec3> planeCorners(const Light& light, const HandleView& view, int plane) {
  const glm::vec3 u = view.metres(1, light.position) * worldAxis((plane + 1) % 3), v = view.metres(1, light.position) * worldAxis((plane + 2) % 3);
  const auto at = [&](float a, float b) { return light.position + a * u + b * v; };
  return {at(kPlaneFrom, kPlaneFrom), at(kPlaneTo, kPlaneFrom), at(kPlaneTo, kPlaneTo), at(kPlaneFrom, kPlaneTo)};
}

std::vector<LightLine> lightOutline(const Light& light, const HandleView& view, bool selected) {
  std::vector<LightLine> lines;
  const glm::vec3 at = light.position;
  if (light.kind == LightKind::Directional) {
    const float radius = sunBall(view);
    const glm::vec3 from = view.target + radius * light.direction;
    lines.push_back({{from - light.direction * view.metres(15, from), view.target + 0.5f * radius * light.direction}});
    if (selected) lines.push_back({arc(view.target, radius * view.right, radius * view.up), true});
  } else if (light.kind == LightKind::Sphere) {
    if (selected) lines.push_back({arc(at, {light.size, 0, 0}, {0, 0, light.size}), true});
    lines.push_back({arc(at, light.size * view.right, light.size * view.up)});
  } else if (light.kind == LightKind::Tube) {
    // The hull of two balls: a half circle around each end, joined.
    const glm::vec3 side = sideOf(light.axis, at, view), half = 0.5f * light.length * light.axis;
    const glm::vec3 out = glm::cross(side, view.forward), way = glm::length(out) > 1e-3f ? glm::normalize(out) : view.up;
    const glm::vec3 end = light.size * (glm::dot(way, light.axis) < 0 ? -way : way), across = light.size * side;
    std::vector<glm::vec3> points = arc(at + half, across, end, 0, kPi, 24);
    const auto back = arc(at - half, across, end, kPi, 2 * kPi, 24);
    points.insert(points.end(), back.begin(), back.end());
    points.push_back(points.front());
    lines.push_back({points});
    lines.push_back({{at - half, at + half}, true});
  } else if (light.kind == LightKind::Rectangle) {
    glm::vec3 right, up;
    acrossAxis(light, right, up);
    const glm::vec3 x = 0.5f * light.width * right, y = 0.5f * light.height * up;
    lines.push_back({{at - x - y, at + x - y, at + x + y, at - x + y, at - x - y}});
    lines.push_back({{at, at + arrowLength(light, view) * light.axis}});
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
    lines.push_back({{at, at + arrowLength(light, view) * light.axis}});
  }
  return lines;
}

LightLine reachOutline(const Light& light, const HandleView& view) { return {arc(light.position, light.radius * view.right, light.radius * view.up, 0, 2 * kPi, 128)}; }

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

std::string lengthText(float metres) {
  if (metres < 0.0095f) return fmt::format("{:.1f} mm", 1000 * metres);
  if (metres < 0.0995f) return fmt::format("{:.1f} cm", 100 * metres);
  if (metres < 0.995f) return fmt::format("{:.0f} cm", 100 * metres);
  return metres < 99.5f ? fmt::format("{:.2f} m", metres) : fmt::format("{:.0f} m", metres);
}

std::string lightIntensity(const Light& light) {
  if (light.kind == LightKind::Directional) return fmt::format("{:.3g} lx", light.lux);
  return fmt::format("{:.4g} lm \u00b7 {:.3g} cd", light.candela * lumensPerCandela(light), light.candela);
}

std::string gripText(const Light& light, LightGrip grip) {
  switch (grip) {
    case LightGrip::Move:
    case LightGrip::PlaneX:
    case LightGrip::PlaneY:
    case LightGrip::PlaneZ: return fmt::format("x {:.2f}  y {:.2f}  z {:.2f} m", light.position.x, light.position.y, light.position.z);
    case LightGrip::AxisX:
    case LightGrip::AxisY:
    case LightGrip::AxisZ: return fmt::format("{} {:.2f} m", "xyz"[axisOf(grip)], light.position[axisOf(grip)]);
    case LightGrip::Aim:
    case LightGrip::Turn: {
      const glm::vec3 d = light.kind == LightKind::Directional ? light.direction : light.axis;
      return fmt::format("height {:.0f}\u00b0  side {:.0f}\u00b0", glm::degrees(std::asin(std::clamp(d.y, -1.0f, 1.0f))), glm::degrees(std::atan2(d.x, d.z)));
    }
    case LightGrip::Size: return "radius " + lengthText(light.size);
    case LightGrip::From:
    case LightGrip::To: return "length " + lengthText(light.length);
    case LightGrip::Left:
    case LightGrip::Right: return "width " + lengthText(light.width);
    case LightGrip::Bottom:
    case LightGrip::Top: return "height " + lengthText(light.height);
    case LightGrip::Outer: return fmt::format("outer angle {:.0f}\u00b0", glm::degrees(light.outerAngle));
    case LightGrip::Inner: return fmt::format("inner angle {:.0f}\u00b0", glm::degrees(light.innerAngle));
    case LightGrip::Reach: return "range " + lengthText(light.radius);
    case LightGrip::Scale:
      if (light.kind == LightKind::Directional) return fmt::format("angular size {:.2f}\u00b0", glm::degrees(light.angle));
      if (light.kind == LightKind::Rectangle) return lengthText(light.width) + " \u00d7 " + lengthText(light.height);
      if (light.kind == LightKind::Tube) return "length " + lengthText(light.length) + ", radius " + lengthText(light.size);
      return gripText(light, light.kind == LightKind::Spot ? LightGrip::Outer : light.kind == LightKind::Sphere ? LightGrip::Size : LightGrip::Reach);
  }
  return {};
}

}  // namespace glint
