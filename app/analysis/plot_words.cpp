// What stands in words on a plot.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/analysis/plot_layout.h"

namespace glint {
namespace {

std::string numbers(const std::vector<float>& values, const char* unit = "") {
  std::vector<std::string> texts;
  for (const float v : values) texts.push_back(fmt::format("{:g}{}", v, unit));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string colorText(const glm::vec3& c) {
  if (c.r == c.g && c.g == c.b) return fmt::format("{:.3g}", c.r);
  return fmt::format("{:.3g}/{:.3g}/{:.3g}", c.r, c.g, c.b);
}

std::string_view partWord(const PlotSettings& s) {
  if (s.parts.size() > 1) return "";
  return s.parts[0] == PlotPart::Specular ? "specular " : s.parts[0] == PlotPart::Diffuse ? "diffuse " : "";
}

}  // namespace

std::string plotTitle(const PlotSettings& s) {
  switch (s.kind) {
    case PlotKind::D: return "Distribution of normals D";
    case PlotKind::G: return "Masking and shadowing G";
    case PlotKind::V: return "Visibility V = G / (4 n\u00b7l n\u00b7v)";
    case PlotKind::F: return "Fresnel reflectance F";
    case PlotKind::Slice: return "Slice of the BRDF over \u03b8_{h} and \u03b8_{d}";
    case PlotKind::Albedo: return s.white ? "Directional albedo in a white furnace" : "Directional albedo";
    case PlotKind::Lobe:
    case PlotKind::Polar: break;
  }
  return s.out == 0 ? "Lobe in the plane of incidence" : fmt::format("Lobe {:g}\u00b0 out of the plane of incidence", s.out);
}

std::string plotConditions(const PlotData& data) {
  const PlotSettings& s = data.settings;
  std::vector<std::string> parts;
  const bool albedo = s.kind == PlotKind::Albedo;
  if (takes(s.kind, "roughness") && !(albedo && s.overRoughness) && s.roughness.size() == 1) parts.push_back("roughness " + numbers(s.roughness));
  if (takes(s.kind, "F0")) parts.push_back("F_{0} " + colorText(data.F0));
  const bool diffuse = takes(s.kind, "part") && (s.parts.size() > 1 || s.parts[0] != PlotPart::Specular);
  if (diffuse) parts.push_back("diffuse color " + colorText(data.diffuseColor));
  if (takes(s.kind, "angle") && !(albedo && !s.overRoughness) && s.angles.size() == 1)
    parts.push_back(fmt::format("{} at {:g}\u00b0{}", s.kind == PlotKind::G || s.kind == PlotKind::V ? "light" : "view", s.angles[0],
                                albedo || s.angles[0] == 0 ? "" : " on the left"));
  if (s.compensate) parts.push_back("multiple scattering");
  if (s.kind == PlotKind::Slice) parts.push_back(fmt::format("\u03c6_{{d}} {:g}\u00b0", s.phi));
  else if (takes(s.kind, "phi") && s.phi != 0) parts.push_back(fmt::format("{:g}\u00b0 from the tangent", s.phi));
  if (takes(s.kind, "channel") && s.channel != PlotChannel::Luminance) parts.push_back(fmt::format("channel{} {}", s.channel == PlotChannel::Rgb ? "s" : "", name(s.channel)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string xTitle(const PlotSettings& s) {
  switch (s.kind) {
    case PlotKind::D: return "\u03b8_{h}, half vector from the normal";
    case PlotKind::G:
    case PlotKind::V: return "\u03b8_{v}, view from the normal";
    case PlotKind::F: return "\u03b8_{d}, light from the half vector";
    case PlotKind::Albedo: return s.overRoughness ? "roughness" : "\u03b8_{v}, view from the normal";
    case PlotKind::Slice: return "\u03b8_{h}, half vector from the normal";
    default: return "\u03b8_{l}, light from the normal";
  }
}

std::string yTitle(const PlotSettings& s) {
  switch (s.kind) {
    case PlotKind::D: return "D, 1/sr";
    case PlotKind::G: return "G, fraction seen by light and view";
    case PlotKind::V: return "V";
    case PlotKind::F: return "F";
    case PlotKind::Albedo: return "albedo";
    default: return fmt::format("{}f{}, 1/sr{}", partWord(s), s.cosine ? " cos \u03b8_{l}" : "",
                                s.kind == PlotKind::Polar && s.log ? ", drawn as log(1 + it)" : "");
  }
}

}  // namespace glint
