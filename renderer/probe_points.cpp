#include "renderer/probe_points.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "renderer/model_setting.h"

namespace glint {
namespace {

using std::numbers::pi;

glm::dvec3 direction(double cosine, double azimuth) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

void addBothWays(ProbePoint p, const glm::dvec3& light, const glm::dvec3& view, std::vector<ProbePoint>& points) {
  p.fromDirections = true;
  p.light = light;
  p.view = view;
  points.push_back(p);
  std::swap(p.light, p.view);
  points.push_back(p);
}

bool readsColors(const ShadingModel& model) { return model.reads("baseColor") || model.reads("specular") || model.reads("metallic"); }

// A number from 0 to 1 for each pair of numbers (Steele et al. 2014, SplitMix).
double hashed(uint64_t a, uint64_t b) {
  uint64_t x = (a * 64 + b + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

float drawn(const ModelParameter& p, uint64_t point, uint64_t component) {
  const double u = hashed(point, 8 + component), x = static_cast<double>(p.minimum) + u * (static_cast<double>(p.maximum) - static_cast<double>(p.minimum));
  if (p.standard.type == ValueType::Bool) return u < 0.5 ? 0 : 1;
  if (p.standard.type == ValueType::Int) return static_cast<float>(std::round(x));
  return static_cast<float>(x);
}

// Attributes as a material may author them, a quarter of them at either end of their range. Where the model reads them, the
// two colours follow from them at every other point.
void author(const ShadingModel& model, uint64_t i, ProbePoint& p) {
  const auto share = [&](uint64_t which) { return static_cast<float>(std::clamp(2 * hashed(i, which) - 0.5, 0.0, 1.0)); };
  p.baseColor = {share(16), share(17), share(18)};
  p.metallic = share(19);
  p.specular = share(20);
  p.fromAttributes = (model.definesColors || !model.authored.empty()) && hashed(i, 21) < 0.5;
  p.plainNonmetal = model.usesPlainNonmetal && hashed(i, 22) < 0.25;
  if (!p.plainNonmetal) return;
  p.metallic = 0;
  p.specular = 0.5f;
  p.fromAttributes = true;
}

// Light and view of a point: even in both angles to the normal, or by turns in the half vector's angles, where narrow lobes
// are.
void addScattered(const ShadingModel& model, uint64_t i, ProbePoint p, std::vector<ProbePoint>& points) {
  // Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences": powers of the root of x^5 = x + 1.
  constexpr double kStep[] = {0.85667488385450287, 0.73389185662280567, 0.62870672103921687, 0.53859725722361016};
  double u[4];
  for (int k = 0; k < 4; ++k) u[k] = std::fmod(0.5 + static_cast<double>(i) * kStep[k], 1.0);
  p.roughness = model.reads("roughness") ? static_cast<float>(u[0]) : 0.5f;
  const float colors[] = {0, 0.04f, 1, static_cast<float>(hashed(i, 0))};
  p.F0 = glm::vec3(readsColors(model) ? colors[static_cast<size_t>(4 * hashed(i, 1))] : 0.04f);
  p.analyticLight = hashed(i, 2) < 0.5;
  author(model, i, p);
  const double turn = model.usesTangent ? 2 * pi * hashed(i, 3) : 0;
  if (i % 2) return addBothWays(p, direction(std::cos(0.5 * pi * u[1]), turn + 2 * pi * u[3]), direction(std::cos(0.5 * pi * u[2]), turn), points);
  const glm::dvec3 half = direction(std::cos(0.5 * pi * u[1] * u[1]), turn);
  const glm::dvec3 side = direction(0, turn + 0.5 * pi), up = glm::cross(half, side);
  const double away = 0.5 * pi * u[2], around = 2 * pi * u[3];
  const glm::dvec3 to = std::sin(away) * (std::cos(around) * side + std::sin(around) * up);
  glm::dvec3 light = std::cos(away) * half + to, view = std::cos(away) * half - to;
  light.z = std::abs(light.z);
  view.z = std::abs(view.z);
  addBothWays(p, light, view, points);
}

}  // namespace

std::vector<ProbePoint> gridPoints(const ShadingModel& model) {
  const std::vector<float> roughnesses = model.reads("roughness") ? std::vector{0.f, 0.02f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.f} : std::vector{0.5f};
  const std::vector<float> reflectances = readsColors(model) ? std::vector{0.f, 0.04f, 1.f} : std::vector{0.04f};
  const double cosines[] = {1e-7, 1e-3, 0.02, 0.1, 0.35, 0.7, 0.95, 1};
  std::vector<ProbePoint> points;
  for (const bool light : {true, false})
    for (const float roughness : roughnesses)
      for (const float F0 : reflectances)
        for (const double l : cosines)
          for (const double v : cosines)
            for (const double azimuth : {0.0, 1.1, 2.6, pi}) {
              ProbePoint p;
              p.roughness = roughness;
              p.F0 = glm::vec3(F0);
              p.analyticLight = light;
              addBothWays(p, direction(l, azimuth), direction(v, 0), points);
            }
  return points;
}

std::vector<ScatteredPoints> scatteredPoints(const ShadingModel& model) {
  constexpr uint64_t kPoints = 8192, kPointsOfConstants = 1024, kConstants = 6;
  const ModelSetting standard = modelSetting(model);
  std::vector<ScatteredPoints> groups;
  uint64_t next = 0;
  const bool anyConstant = std::any_of(model.parameters.begin(), model.parameters.end(), [](const ModelParameter& p) { return p.slot < 0; });
  for (uint64_t g = 0; g <= (anyConstant ? kConstants : 0); ++g) {
    ScatteredPoints group{{}, standard.constants};
    size_t constant = 0;
    for (const ModelParameter& p : model.parameters)
      if (p.slot < 0) {
        for (int c = 0; g > 0 && c < 4; ++c) group.constants[constant][c] = drawn(p, next, static_cast<uint64_t>(32 + 4 * constant) + static_cast<uint64_t>(c));
        ++constant;
      }
    for (uint64_t i = 0; i < (g == 0 ? kPoints : kPointsOfConstants); ++i, ++next) {
      ProbePoint point;
      point.a = {standard.slots[0], standard.slots[1], standard.slots[2], standard.slots[3]};
      point.ownParameters = !model.parameters.empty() && (g > 0 || hashed(next, 4) < 0.5);
      for (const ModelParameter& p : model.parameters)
        for (int c = 0; point.ownParameters && p.slot >= 0 && c < componentCount(p.standard.type) && p.slot + c < 4; ++c)
          point.a[p.slot + c] = drawn(p, next, static_cast<uint64_t>(p.slot + c));
      addScattered(model, next, point, group.points);
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<IntegralQuery> authoredQueries(const ShadingModel& model, const std::vector<float>& roughness, const std::vector<float>& NoV, int count) {
  std::vector<IntegralQuery> queries;
  const std::vector<std::string>& own = model.authored;
  const auto ask = [&](const IntegralQuery::Authored& authored) {
    const size_t i = queries.size();
    queries.push_back({.roughness = model.reads("roughness") ? roughness[i * 3 % roughness.size()] : 0.5f, .NoV = NoV[i * 7 % NoV.size()],
                       .analyticLight = i % 2 == 0, .authored = authored});
  };
  // One by turns from one end to the other, against the rest of them.
  for (int i = 0; i < count && !own.empty(); ++i) {
    const float step = static_cast<float>(i) / static_cast<float>(count - 1);
    const auto share = [&](const char* attribute, float standard) {
      return std::find(own.begin(), own.end(), attribute) == own.end() ? standard : attribute == own[static_cast<size_t>(i) % own.size()] ? step : 1 - step;
    };
    ask({glm::vec3(share("baseColor", 1)), share("metallic", 0), share("specular", 0.5f), false});
  }
  for (size_t i = 0; i < roughness.size() && model.usesPlainNonmetal; ++i) ask({glm::vec3(1), 0, 0.5f, true});
  return queries;
}

std::string attributesText(const ShadingModel& model, const ProbePoint& p) {
  if (p.plainNonmetal) return fmt::format(", metallic and specular unconnected, baseColor {:.3g}/{:.3g}/{:.3g}", p.baseColor.r, p.baseColor.g, p.baseColor.b);
  std::string text = p.fromAttributes || model.isWhole() ? "" : fmt::format(", F0 {:.2g}", p.F0.g);
  const auto tells = [&](const char* attribute) {
    return p.fromAttributes || std::find(model.authored.begin(), model.authored.end(), attribute) != model.authored.end();
  };
  if (tells("metallic")) text += fmt::format(", metallic {:.3g}", p.metallic);
  if (tells("specular")) text += fmt::format(", specular {:.3g}", p.specular);
  if (tells("baseColor")) text += fmt::format(", baseColor {:.3g}/{:.3g}/{:.3g}", p.baseColor.r, p.baseColor.g, p.baseColor.b);
  return text;
}

std::string parametersText(const ShadingModel& model, const ProbePoint& point, const std::vector<glm::vec4>& constants) {
  std::string text;
  size_t constant = 0;
  for (const ModelParameter& p : model.parameters) {
    text += ", " + (p.fileName.empty() ? p.name : p.fileName);
    for (int c = 0; c < componentCount(p.standard.type); ++c)
      text += fmt::format("{}{:.4g}", c ? "/" : " ", p.slot >= 0 ? point.a[std::min(p.slot + c, 3)] : constants[constant][c]);
    constant += p.slot < 0;
  }
  return text;
}

}  // namespace glint
