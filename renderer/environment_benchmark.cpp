#include "renderer/environment_benchmark.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "renderer/environment.h"
#include "renderer/environment_spots.h"
#include "renderer/parallel.h"

namespace glint {
namespace {

std::vector<float> levelPixels(GLuint cube, int level) {
  const size_t size = size_t(EnvironmentLighting::kSize >> level);
  std::vector<float> pixels(size * size * 6 * 3);
  glGetTextureImage(cube, level, GL_RGB, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)), pixels.data());
  return pixels;
}

// A pixel of the environment, with its radiance times its solid angle.
struct SourcePixel {
  glm::vec3 direction, light;
  float angle;
};

std::vector<SourcePixel> sourcePixels(const ImageF& image) {
  std::vector<SourcePixel> pixels;
  pixels.reserve(image.data.size() / 3);
  for (int y = 0; y < image.height; ++y) {
    const float angle = static_cast<float>(solidAngle(y, image.width, image.height));
    for (int x = 0; x < image.width; ++x) {
      const float* p = image.at(x, y);
      pixels.push_back({environmentDirection(x, y, image.width, image.height), glm::vec3(p[0], p[1], p[2]) * angle, angle});
    }
  }
  return pixels;
}

// A lobe over the root of half the chord to its axis, where both narrow and wide ones are smooth.
class LobeTable {
 public:
  explicit LobeTable(const std::vector<float>& kernel) : values_(kEntries + 2, 0.0f) {
    const float n = static_cast<float>(kernel.size());
    for (size_t i = 0; i <= kEntries; ++i) {
      const float root = static_cast<float>(i) / kEntries * kEnd, angle = 2 * std::asin(std::min(root * root, 1.0f));
      const float at = std::sqrt(angle / (0.5f * std::numbers::pi_v<float>)) * n - 0.5f;
      if (at >= n - 0.5f) continue;
      const float low = std::clamp(std::floor(at), 0.0f, n - 2), share = std::clamp(at - low, 0.0f, 1.0f);
      const size_t k = static_cast<size_t>(low);
      values_[i] = std::max(0.0f, kernel[k] + share * (kernel[k + 1] - kernel[k]));
    }
  }

  // Of the light, weighted by the lobe around the axis.
  glm::dvec3 average(const glm::vec3& axis, const std::vector<SourcePixel>& source) const {
    glm::dvec3 sum(0);
    double mass = 0;
    for (const SourcePixel& pixel : source) {
      const glm::vec3 to = pixel.direction - axis;
      const float chord2 = glm::dot(to, to);
      if (chord2 >= 2) continue;  // beyond a right angle
      const float at = std::sqrt(0.5f * std::sqrt(chord2)) * (kEntries / kEnd);
      const size_t k = static_cast<size_t>(at);
      const float value = values_[k] + (at - static_cast<float>(k)) * (values_[k + 1] - values_[k]);
      sum += glm::dvec3(value * pixel.light);
      mass += static_cast<double>(value * pixel.angle);
    }
    return mass > 0 ? sum / mass : glm::dvec3(0);
  }

 private:
  static constexpr size_t kEntries = 4096;
  static constexpr float kEnd = 0.8409f;  // the root of the sine of 45 degrees, rounded up
  std::vector<float> values_;
};

// A texel, and for how many it stands.
struct Chosen {
  size_t texel;
  double weight;
};

std::vector<Chosen> choose(const std::vector<float>& pixels, size_t most) {
  std::vector<size_t> texels(pixels.size() / 3);
  std::iota(texels.begin(), texels.end(), size_t{0});
  std::vector<Chosen> chosen;
  if (texels.size() <= 2 * most) {
    for (const size_t texel : texels) chosen.push_back({texel, 1});
    return chosen;
  }
  const auto light = [&](size_t texel) { return pixels[3 * texel] + pixels[3 * texel + 1] + pixels[3 * texel + 2]; };
  std::nth_element(texels.begin(), texels.begin() + static_cast<std::ptrdiff_t>(most), texels.end(), [&](size_t a, size_t b) { return light(a) > light(b); });
  for (size_t i = 0; i < most; ++i) chosen.push_back({texels[i], 1});
  std::sort(texels.begin() + static_cast<std::ptrdiff_t>(most), texels.end());
  const double rest = static_cast<double>(texels.size() - most);
  for (size_t i = 0; i < most; ++i) chosen.push_back({texels[most + static_cast<size_t>((static_cast<double>(i) + 0.5) * rest / static_cast<double>(most))], rest / static_cast<double>(most)});
  return chosen;
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

Result<std::vector<double>> EnvironmentBenchmark::errors(const EnvironmentPtr& environment, size_t texels) {
  EnvironmentLighting lighting(programs_, rectangles_, false);
  const auto rows = lighting.lobe(setting_);
  if (!rows) return rows.diagnostics();
  const auto cube = lighting.prefiltered(environment, setting_);
  if (!cube) return cube.diagnostics();
  const double scale = static_cast<double>(lighting.maps(environment).scale);
  const std::vector<SourcePixel> source = sourcePixels(environment->pixels);
  std::vector<double> errors;
  for (int level = 1; level < EnvironmentLighting::kLevels; ++level) {
    const std::vector<float> pixels = levelPixels(*cube, level);
    const std::vector<Chosen> chosen = choose(pixels, texels);
    const LobeTable table((*rows)[static_cast<size_t>(level)]);
    const size_t size = size_t(EnvironmentLighting::kSize >> level);
    std::vector<double> differences(chosen.size()), wholes(chosen.size());
    parallelFor(chosen.size(), [&](size_t i) {
      const size_t texel = chosen[i].texel, face = texel / (size * size), y = texel / size % size, x = texel % size;
      const glm::vec3 direction = glm::normalize(cubeDirection(static_cast<int>(face), (glm::vec2(x, y) + 0.5f) / static_cast<float>(size)));
      const glm::dvec3 exact = table.average(direction, source);
      for (int c = 0; c < 3; ++c) {
        const double got = static_cast<double>(pixels[3 * texel + static_cast<size_t>(c)]) / scale;
        differences[i] += (got - exact[c]) * (got - exact[c]);
        wholes[i] += exact[c] * exact[c];
      }
    });
    double difference = 0, whole = 0;
    for (size_t i = 0; i < chosen.size(); ++i) {
      difference += chosen[i].weight * differences[i];
      whole += chosen[i].weight * wholes[i];
    }
    errors.push_back(std::sqrt(difference / std::max(whole, 1e-300)));
  }
  return errors;
}

}  // namespace glint
