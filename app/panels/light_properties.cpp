#include "app/panels/light_properties.h"

#include <algorithm>
#include <cmath>

#include "app/editor/ui.h"

namespace glint {
namespace {

using Unit = LightProperty::Unit;

// As an artist thinks of a sun or a lamp: how high, and to which side.
bool direction(const LightProperty& p, glm::vec3& d) {
  float height = glm::degrees(std::asin(std::clamp(d.y, -1.0f, 1.0f)));
  float side = glm::degrees(std::atan2(d.x, d.z));
  ui::beginProperty("Height", std::string(p.doc) + ": degrees above the horizon");
  bool turned = ui::slider("Height", height, -89.9f, 89.9f, "%.0f\u00b0");
  ui::endProperty();
  ui::beginProperty("Side", std::string(p.doc) + ": degrees about the vertical axis, from the viewer\u2019s side");
  turned |= ui::slider("Side", side, -180, 180, "%.0f\u00b0");
  ui::endProperty();
  if (!turned) return false;
  const float h = glm::radians(height), s = glm::radians(side);
  d = {std::cos(h) * std::sin(s), std::sin(h), std::cos(h) * std::cos(s)};
  return true;
}

// Light spans many powers of ten: a drag changes a share of what there is, and as many digits are shown as tell it.
float stepOf(float amount) { return std::max(0.01f * amount, 0.01f); }
std::string decimalsOf(float amount) { return amount < 10 ? "%.2f" : amount < 100 ? "%.1f" : "%.0f"; }

bool power(Light& light, const LightProperty& p) {
  float lumens = light.candela * lumensPerCandela(light);
  const bool changed = ui::drag(p.title, &lumens, 1, stepOf(lumens), 0, 1e7f, (decimalsOf(lumens) + " lm").c_str());
  if (changed) light.candela = lumens / std::max(lumensPerCandela(light), 1e-6f);
  const float nits = light.candela * nitsPerCandela(light);
  ui::tooltip(fmt::format("{:.4g} cd{}. A candle gives 12 lm, a bulb 800, a studio lamp 20,000", light.candela, nits > 0 ? fmt::format(", {:.4g} nits on its surface", nits) : ""));
  return changed;
}

bool number(Light& light, const LightProperty& p) {
  float& value = light.*p.number;
  if (p.unit == Unit::Degrees) {
    float degrees = glm::degrees(value);
    if (!ui::slider(p.title, degrees, std::max(glm::degrees(p.least), -180.0f), std::min(glm::degrees(p.most), 180.0f), p.most < 1 ? "%.2f\u00b0" : "%.0f\u00b0")) return false;
    value = glm::radians(degrees);
    return true;
  }
  if (p.unit == Unit::Lux) {
    const bool changed = ui::drag(p.title, &value, 1, stepOf(value), p.least, std::min(p.most, 1e6f), (decimalsOf(value) + " lx").c_str());
    ui::tooltip("Full moon 0.2 lx, office 500, overcast sky 10,000, sun 100,000: set the exposure to suit");
    return changed;
  }
  return ui::drag(p.title, &value, 1, 0.01f, p.least, std::min(p.most, 1e4f), p.unit == Unit::Metres ? "%.2f m" : "%.2f");
}

}  // namespace

bool lightProperties(Light& light) {
  bool changed = false;
  for (const LightProperty& p : infoOf(light.kind).properties) {
    if (p.unit == Unit::Direction) {
      changed |= direction(p, light.*p.vector);
      continue;
    }
    ui::beginProperty(p.title, p.doc);
    if (p.flag) changed |= ui::checkbox(p.title, light.*p.flag);
    else if (p.unit == Unit::Color) changed |= ui::color(p.title, &(light.*p.vector).x, 1);
    else if (p.unit == Unit::Position) changed |= ui::drag(p.title, &(light.*p.vector).x, 3, 0.02f, -1e4f, 1e4f, "%.2f");
    else if (p.unit == Unit::Candela) changed |= power(light, p);
    else changed |= number(light, p);
    ui::endProperty();
  }
  light.innerAngle = std::min(light.innerAngle, light.outerAngle);
  return changed;
}

std::span<const LightPreset> lightPresets() {
  static constexpr LightPreset kPresets[] = {
      {"Three-point", "A large key from the front, a weaker fill from the other side, and a rim from behind",
       [] {
         const auto panel = [](glm::vec3 at, float lumens, float width, float height, glm::vec3 color) {
           Light light{.kind = LightKind::Rectangle, .color = color, .position = at, .radius = 30, .axis = glm::normalize(-at), .width = width, .height = height};
           light.candela = lumens / lumensPerCandela(light);
           return light;
         };
         return std::vector<Light>{panel({2.2f, 2.2f, 2.8f}, 260, 1.6f, 1.6f, {1, 0.95f, 0.88f}), panel({-3, 0.8f, 2.2f}, 110, 2.2f, 1.4f, {0.85f, 0.92f, 1}),
                                   panel({-1.2f, 2.4f, -2.8f}, 220, 2, 0.6f, {1, 1, 1})};
       }},
      {"Sun", "One directional light, high from the front",
       [] { return std::vector<Light>{{.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(0.6f, 1, 0.8f)), .lux = 6.2831853f}}; }},
      {"Sphere, figure 12", "A ball above, as in the course notes\u2019 figure 12",
       [] { return std::vector<Light>{{.kind = LightKind::Sphere, .position = {0.8f, 1.9f, 1.6f}, .candela = 14, .radius = 20, .size = 0.5f}}; }},
      {"Tube, figure 13", "A tube above, as in the course notes\u2019 figure 13",
       [] { return std::vector<Light>{{.kind = LightKind::Tube, .position = {0, 1.7f, 1.6f}, .candela = 14, .radius = 20, .axis = {1, 0, 0}, .size = 0.04f, .length = 2.4f}}; }}};
  return kPresets;
}

Light newLight(LightKind kind) {
  Light light;
  light.kind = kind;
  light.direction = glm::normalize(glm::vec3(1, 1.2f, 1));
  light.position = {1.5f, 2, 2.5f};
  light.axis = kind == LightKind::Tube ? glm::vec3(1, 0, 0) : glm::normalize(-light.position);
  light.candela = kind == LightKind::Spot ? 40.0f : 15.0f;
  light.radius = 20;
  if (kind == LightKind::Sphere) light.size = 0.3f;
  return light;
}

}  // namespace glint
