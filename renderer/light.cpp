#include "renderer/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/base/check.h"

namespace glint {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
using Unit = LightProperty::Unit;

const LightProperty kColor{"color", "color", "Colour", "Factor on the light, linear", Unit::Color, nullptr, &Light::color};
const LightProperty kPosition{"position", "pos", "Position", "Of the middle, metres", Unit::Position, nullptr, &Light::position};
const LightProperty kPower{"candela", "cd", "Power", "Of a point light of the same power, candela; lumens / 4 pi", Unit::Candela, &Light::candela};
const LightProperty kRange{"radius", "radius", "Range", "Metres from the middle, beyond which it has no effect", Unit::Metres, &Light::radius, nullptr, 1e-3f};
const LightProperty kConstant{"constant", "constant", "Falloff constant", "What is added to the squared distance: 1 in the notes, 0 in nature", Unit::None, &Light::constant};
const LightProperty kAxis{"axis", "dir", "Direction", "The way it shines", Unit::Direction, nullptr, &Light::axis};
const LightProperty kSize{"size", "size", "Radius", "Of the source, metres", Unit::Metres, &Light::size};
const LightProperty kShadow{"shadow", "shadow", "Shadow", "Whether it casts one when shadows are on", Unit::Switch, nullptr, nullptr, 0, 1, &Light::shadow};

LightProperty spotAngle(const char* key, const char* option, const char* title, const char* doc, float Light::*angle) {
  return {key, option, title, doc, Unit::Degrees, angle, nullptr, 0, 0.5f * kPi};
}

const std::vector<LightKindInfo>& kinds() {
  static const std::vector<LightKindInfo> all = {
      {LightKind::Directional, "directional", "Directional", "dir=1/1/1,lux=3.14",
       {{"direction", "dir", "Direction", "Towards the light", Unit::Direction, nullptr, &Light::direction},
        {"lux", "lux", "Illuminance", "Lux: pi makes a white surface that faces it show 1", Unit::Lux, &Light::lux},
        kColor,
        {"angle", "angle", "Angular size", "Across, as seen from the scene: how soft its shadow is; the sun has 0.53 degrees", Unit::Degrees, &Light::angle, nullptr, 0,
         kPi / 6},
        kShadow}},
      {LightKind::Point, "point", "Point", "pos=0/2/2,lumens=800", {kPosition, kPower, kColor, kRange, kConstant, kShadow}},
      {LightKind::Spot, "spot", "Spot", "pos=0/3/2,to=0/0/0,lumens=800,outer=30",
       {kPosition,
        kAxis,
        {"candela", "cd", "Power", "Along its axis, candela", Unit::Candela, &Light::candela},
        spotAngle("innerAngle", "inner", "Inner angle", "From the axis to where it is still full", &Light::innerAngle),
        spotAngle("outerAngle", "outer", "Outer angle", "From the axis to where it ends", &Light::outerAngle),
        {"size", "size", "Radius", "Of the source, metres: how soft its shadow is", Unit::Metres, &Light::size},
        kColor,
        kRange,
        kConstant,
        kShadow}},
      {LightKind::Sphere, "sphere", "Sphere", "pos=0/2/2,lumens=800,size=0.3", {kPosition, kSize, kPower, kColor, kRange, kConstant, kShadow}},
      {LightKind::Tube, "tube", "Tube", "from=-1/2/2,to=1/2/2,lumens=800,size=0.05",
       {kPosition,
        {"axis", "dir", "Direction", "Along the tube", Unit::Direction, nullptr, &Light::axis},
        {"length", "length", "Length", "Between the middles of its round ends, metres", Unit::Metres, &Light::length},
        kSize,
        kPower,
        kColor,
        kRange,
        kConstant,
        kShadow}},
      {LightKind::Rectangle, "rectangle", "Rectangle", "pos=0/2/2,to=0/0/0,lumens=800,width=1,height=0.5",
       {kPosition,
        kAxis,
        {"width", "width", "Width", "Metres", Unit::Metres, &Light::width},
        {"height", "height", "Height", "Metres", Unit::Metres, &Light::height},
        {"roll", "roll", "Roll", "Turned about the way it shines", Unit::Degrees, &Light::roll, nullptr, -2 * kPi, 2 * kPi},
        kPower,
        kColor,
        kRange,
        kConstant,
        kShadow}}};
  return all;
}

}  // namespace

float surfaceArea(const Light& light) {
  if (light.kind == LightKind::Sphere) return 4 * kPi * light.size * light.size;
  if (light.kind == LightKind::Tube) return 2 * kPi * light.size * (2 * light.size + light.length);
  if (light.kind == LightKind::Rectangle) return light.width * light.height;
  return 0;
}

float lumensPerCandela(const Light& light) {
  if (light.kind != LightKind::Spot) return 4 * kPi;
  const float inner = std::cos(std::min(light.innerAngle, light.outerAngle)), outer = std::cos(light.outerAngle);
  // The profile is the square of a line in the cosine (shaders/common/lights.glsl).
  return 2 * kPi * (1 - inner + (inner - outer) / 3);
}

float nitsPerCandela(const Light& light) {
  const float area = surfaceArea(light);
  return area > 0 ? lumensPerCandela(light) / (kPi * area) : 0;
}

bool isSound(const Light& light) {
  bool sound = true;
  for (const LightProperty& p : infoOf(light.kind).properties) {
    if (p.number) sound &= std::isfinite(light.*p.number);
    if (!p.vector) continue;
    const glm::vec3 v = light.*p.vector;
    sound &= std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    if (p.unit == Unit::Direction) sound &= glm::dot(v, v) > 1e-12f;
  }
  return sound;
}

float extent(const Light& light) {
  if (light.kind == LightKind::Sphere) return light.size;
  if (light.kind == LightKind::Tube) return light.size + 0.5f * light.length;
  if (light.kind == LightKind::Rectangle) return 0.5f * std::hypot(light.width, light.height);
  return 0;
}

void acrossAxis(const Light& light, glm::vec3& right, glm::vec3& up) {
  const glm::vec3 helper = std::abs(light.axis.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 x = glm::normalize(glm::cross(helper, light.axis)), y = glm::cross(light.axis, x);
  right = std::cos(light.roll) * x + std::sin(light.roll) * y;
  up = std::cos(light.roll) * y - std::sin(light.roll) * x;
}

std::span<const LightKindInfo> lightKinds() { return kinds(); }

const LightKindInfo& infoOf(LightKind kind) {
  for (const LightKindInfo& info : kinds())
    if (info.kind == kind) return info;
  GLINT_CHECK(false, "kind {}", static_cast<int>(kind));
  return kinds().front();
}

const LightKindInfo* findLightKind(std::string_view id) {
  for (const LightKindInfo& info : kinds())
    if (id == info.id) return &info;
  return nullptr;
}

}  // namespace glint
