#include "renderer/environment_benchmark.h"

#include <cmath>

namespace glint {
namespace {

std::vector<float> levelPixels(const gl::Texture& cube, int level) {
  const size_t size = size_t(EnvironmentLighting::kSize >> level);
  std::vector<float> pixels(size * size * 6 * 3);
  glGetTextureImage(cube.id(), level, GL_RGB, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)), pixels.data());
  return pixels;
}

}  // namespace

EnvironmentBenchmark::EnvironmentBenchmark(std::shared_ptr<const ShadingModel> model)
    : setting_(modelSetting(std::make_shared<ModelShader>(std::move(model)), {})) {}

Diagnostics EnvironmentBenchmark::prefilter(const EnvironmentPtr& environment) {
  EnvironmentLighting lighting(programs_, rectangles_, false);
  const auto made = lighting.prefiltered(environment, setting_);
  glFinish();
  return made ? Diagnostics{} : made.diagnostics();
}

Diagnostics EnvironmentBenchmark::brdf() {
  EnvironmentLighting lighting(programs_, rectangles_, false);
  const auto made = lighting.brdf(setting_);
  glFinish();
  return made ? Diagnostics{} : made.diagnostics();
}

Result<std::vector<double>> EnvironmentBenchmark::errors(const EnvironmentPtr& environment) {
  EnvironmentLighting lighting(programs_, rectangles_, false);
  std::array<int, EnvironmentLighting::kLevels> standard, reference;
  for (int level = 0; level < EnvironmentLighting::kLevels; ++level) {
    standard[size_t(level)] = EnvironmentLighting::levelSamples(level);
    reference[size_t(level)] = level == 0 ? 1 : kReferenceSamples;
  }
  const auto fast = lighting.prefilter(environment, setting_, standard);
  if (!fast) return fast.diagnostics();
  const auto slow = lighting.prefilter(environment, setting_, reference);
  if (!slow) return slow.diagnostics();
  std::vector<double> errors;
  for (int level = 1; level < EnvironmentLighting::kLevels; ++level) {
    const std::vector<float> a = levelPixels(*fast, level), b = levelPixels(*slow, level);
    double difference = 0, total = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      difference += double(a[i] - b[i]) * double(a[i] - b[i]);
      total += double(b[i]) * double(b[i]);
    }
    errors.push_back(std::sqrt(difference / std::max(total, 1e-30)));
  }
  return errors;
}

}  // namespace glint
