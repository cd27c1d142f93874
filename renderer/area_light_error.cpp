#include "renderer/area_light_error.h"

#include <cmath>
#include <numbers>

#include "renderer/cosine_fit.h"
#include "renderer/lobe_points.h"

namespace glint {
namespace {

using std::numbers::pi;

// Lights as wide as a lamp at arm's length (half of them within 17 degrees), soft enough for sums over a lobe's points.
constexpr int kLights = 48;
constexpr double kSharpness = 16;
// Evenly over the upper hemisphere (Fibonacci's spiral).
glm::dvec3 lightAt(int i) {
  const double z = (i + 0.5) / kLights, phi = i * pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// Of a cosine lobe through that matrix, above the horizon.
double throughLobe(const CosineFit& fit, const glm::dvec3& light) {
  constexpr int kRings = 32, kAround = 48;
  double sum = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      const double u = (i + 0.5) / kRings, phi = 2 * pi * (j + 0.5) / kAround, r = std::sqrt(u);
      const glm::dvec3 w = glm::normalize(fit.matrix * glm::dvec3(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)));
      if (w.z > 0) sum += std::exp(kSharpness * (glm::dot(w, light) - 1));
    }
  return sum / (kRings * kAround);
}

}  // namespace

AreaLightError areaLightError(const ModelProbe& probe) {
  constexpr float kRoughness[] = {0.15f, 0.3f, 0.6f, 0.9f}, kNoV[] = {0.15f, 0.4f, 0.8f};
  std::vector<ProbePoint> points;
  std::vector<LobeDirection> directions;
  for (const float roughness : kRoughness)
    for (const float NoV : kNoV) addLobePoints({std::sqrt(1 - NoV * NoV), 0, NoV}, roughness, 1, true, points, directions);
  const std::vector<glm::vec4> out = probe.evaluate(points);

  AreaLightError error;
  int count = 0;
  size_t first = 0;
  for (const float roughness : kRoughness)
    for (const float NoV : kNoV) {
      std::vector<LobeSample> samples;
      double all = 0;
      for (size_t i = first; i < first + kLobePoints; ++i) {
        const LobeDirection& d = directions[i];
        if (d.weight <= 0) continue;
        samples.push_back({d.light, d.weight / d.light.z, std::max(0.0, double(out[2 * i].g)) * d.light.z});
        all += samples.back().solidAngle * samples.back().sent;
      }
      first += kLobePoints;
      const CosineFit fit = fitCosine(samples);
      if (!fit.known || all < 1e-6) continue;
      double off = 0, sum = 0;
      for (int k = 0; k < kLights; ++k) {
        const glm::dvec3 light = lightAt(k);
        double exact = 0;
        for (const LobeSample& s : samples) exact += s.solidAngle * s.sent * std::exp(kSharpness * (glm::dot(s.direction, light) - 1));
        off += std::abs(throughLobe(fit, light) * all / fit.above - exact);
        sum += exact;
      }
      const double relative = off / std::max(sum, 1e-12);
      error.mean += relative;
      ++count;
      if (relative > error.worst) error = {error.mean, relative, roughness, NoV};
    }
  if (count > 0) error.mean /= count;
  return error;
}

}  // namespace glint
