#include "renderer/sampler_error.h"

#include <cmath>
#include <numbers>

namespace glint {
namespace {

struct Errors {
  double own = 0, cosine = 0;
};

// The relative standard errors of the mean of f NoL / pdf by the sampler and by the cosine, both from the sampler's own
// directions: the cosine's would seldom meet a narrow lobe. 0 for what reflects nothing.
Errors relativeErrors(const ModelProbe& probe, const DirectionSampler& sampler, const glm::dvec3& view, float roughness) {
  std::vector<ProbePoint> points;
  std::vector<SampledDirection> directions;
  for (int i = 0; i < SamplerError::kSamples; ++i) {
    // The plastic sequence: evenly spread over the square.
    const SampledDirection drawn = sampler.sample(std::fmod(0.5 + i * 0.7548776662466927, 1.0), std::fmod(0.5 + i * 0.5698402909980532, 1.0));
    points.push_back(ProbePoint::at(drawn.light, view));
    points.back().roughness = roughness;
    points.back().F0 = glm::vec3(1);
    points.back().diffuseColor = glm::vec3(0);
    points.back().metallic = 1;
    points.back().fromDirections = true;
    directions.push_back(drawn);
  }
  const std::vector<glm::vec4> f = probe.evaluate(points);
  const size_t outputs = static_cast<size_t>(probe.outputs());
  double sum = 0, squares = 0, cosineSquares = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double x = static_cast<double>(f[outputs * i].g) * directions[i].light.z / directions[i].pdf;
    sum += x;
    squares += x * x;
    cosineSquares += x * x * directions[i].pdf / (directions[i].light.z / std::numbers::pi);
  }
  const double mean = sum / SamplerError::kSamples;
  if (mean < 1e-6) return {};
  const auto error = [&](double all) { return std::sqrt(std::max(all / SamplerError::kSamples - mean * mean, 0.0) / SamplerError::kSamples) / mean; };
  return {error(squares), error(cosineSquares)};
}

}  // namespace

SamplerError samplerError(const ModelProbe& probe, const ModelSampler& sampler) {
  SamplerError error;
  for (const float roughness : {0.1f, 0.4f, 1.f})
    for (const float NoV : {0.2f, 0.8f}) {
      const glm::dvec3 view(std::sqrt(1 - NoV * NoV), 0, NoV);
      const Errors found = relativeErrors(probe, sampler.at(view, roughness, glm::dvec3(1), glm::dvec3(0)), view, roughness);
      if (found.own > error.worst) error = {found.own, found.cosine, roughness, NoV};
    }
  return error;
}

}  // namespace glint
