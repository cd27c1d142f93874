#include "renderer/split_sum_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/lobe_points.h"

namespace glint {
namespace {

using std::numbers::pi;

// A dim sky with a window, a lamp and light from the ground's side: soft enough for this quadrature.
double radiance(const glm::dvec3& l) {
  struct Lobe {
    glm::dvec3 axis;
    double amplitude, sharpness;
  };
  static const Lobe lobes[] = {{{0.6, 0, 0.8}, 2, 6}, {{-0.48, 0.64, 0.6}, 3, 15}, {{0, -0.8, 0.6}, 6, 40}};
  double sum = 0.3 + 0.15 * l.z;
  for (const Lobe& lobe : lobes) sum += lobe.amplitude * std::exp(lobe.sharpness * (glm::dot(l, lobe.axis) - 1));
  return sum;
}

// The value that half of the light, by solid angle and cosine, comes back above: modelFloor() of
// shaders/common/floor_light.glsl.
double weightedMedian(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double sum = 0, whole = 0;
  for (const auto& [value, weight] : values) whole += weight;
  for (const auto& [value, weight] : values)
    if ((sum += weight) >= 0.5 * whole) return value;
  return 0;
}

}  // namespace

SplitSumError splitSumError(const ModelProbe& probe, const ModelIntegrals& integrals, const ModelProbe* environment) {
  constexpr float kRoughness[] = {0.15f, 0.3f, 0.6f, 0.9f}, kNoV[] = {0.15f, 0.4f, 0.8f}, kF0[] = {0.04f, 1.f};
  const size_t size = kLobePoints;
  std::vector<ProbePoint> points;
  std::vector<LobeDirection> directions;
  std::vector<IntegralQuery> queries;
  std::vector<ProbePoint> reflections;
  for (const float roughness : kRoughness) {
    addLobePoints({0, 0, 1}, roughness, 1, false, points, directions);  // the lobe along the normal
    for (const float NoV : kNoV) {
      queries.push_back({roughness, NoV, false});
      for (const float F0 : kF0) {
        const glm::dvec3 view(std::sqrt(1 - NoV * NoV), 0, NoV);
        addLobePoints(view, roughness, F0, false, points, directions);
        ProbePoint p = ProbePoint::at({-view.x, 0, NoV}, view);
        p.roughness = roughness;
        p.F0 = glm::vec3(F0);
        p.analyticLight = false;
        reflections.push_back(p);
      }
    }
  }
  const std::vector<glm::vec4> out = probe.evaluate(points);
  const std::vector<ModelIntegral> tables = integrals.evaluate(queries);
  const std::vector<glm::vec4> own = environment ? environment->evaluate(reflections) : std::vector<glm::vec4>{};

  SplitSumError error;
  double squares = 0;
  size_t block = 0, query = 0, reflection = 0;
  int count = 0;
  const auto specular = [&](size_t i) { return out[2 * i].g * directions[i].weight; };
  // Of a whole model the base is lit as diffuse, and the lobe is what is above it.
  const auto baseOf = [&](size_t at) {
    std::vector<std::pair<double, double>> values;
    if (!probe.model().isWhole()) return 0.0;
    for (size_t i = at * size; i < (at + 1) * size; ++i) values.emplace_back(std::max(out[2 * i].g, 0.f), directions[i].weight);
    return weightedMedian(std::move(values));
  };
  for (const float roughness : kRoughness) {
    const size_t lobe = block++;
    const double lobeBase = baseOf(lobe);
    double irradiance = 0;
    for (size_t i = lobe * size; i < (lobe + 1) * size; ++i) irradiance += directions[i].weight * radiance(directions[i].light);
    for (const float NoV : kNoV) {
      const glm::dvec3 reflected(-std::sqrt(1 - NoV * NoV), 0, NoV);
      // The lobe turned from the normal to the reflected view.
      const glm::dvec3 side(0, 1, 0), across = glm::cross(side, reflected);
      double filtered = 0, total = 0;
      for (size_t i = lobe * size; i < (lobe + 1) * size; ++i) {
        const glm::dvec3& l = directions[i].light;
        const double above = probe.model().isWhole() ? std::max(0.0, out[2 * i].g - lobeBase) * directions[i].weight : specular(i);
        filtered += above * radiance(l.x * across + l.y * side + l.z * reflected);
        total += above;
      }
      const ModelIntegral& table = tables[query++];
      for (const float F0 : kF0) {
        double exact = 0;
        const double base = baseOf(block);
        for (size_t i = block * size; i < (block + 1) * size; ++i) exact += specular(i) * radiance(directions[i].light);
        ++block;
        const double B = table.specularBlack.g, A = table.specular.g - B;
        const double albedo = own.empty() ? F0 * A + B : own[reflection].g, diffuse = std::min(pi * base, albedo);
        ++reflection;
        if (exact < 1e-6 || (total <= 0 && base <= 0)) continue;
        const double relative = ((total > 0 ? filtered / total : 0) * (albedo - diffuse) + irradiance / pi * diffuse) / exact - 1;
        squares += relative * relative;
        ++count;
        if (std::abs(relative) > std::abs(error.worst)) error = {0, relative, roughness, NoV};
      }
    }
  }
  error.rms = count ? std::sqrt(squares / count) : 0;
  return error;
}

}  // namespace glint
