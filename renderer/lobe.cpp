#include "renderer/lobe.h"

#include <algorithm>
#include <cmath>

#include "materials/base/check.h"

namespace glint {
namespace {

constexpr double kHalfPi = 1.57079632679489662, kTau = 6.28318530717958648;

// Turning by it each time fills a disc evenly (Vogel 1979, "A better way to construct the sunflower head").
constexpr double kGolden = 0.61803398874989485;

// The lower end of an entry's interval.
double edgeAngle(size_t i, size_t size) {
  const double u = static_cast<double>(i) / static_cast<double>(size);
  return kHalfPi * u * u;
}

// The lobe's mass up to the upper end of each entry's interval: kernel sin(theta) d theta.
std::vector<double> massOf(std::span<const float> kernel) {
  const size_t n = kernel.size();
  std::vector<double> mass(n + 1, 0.0);
  for (size_t i = 0; i < n; ++i)
    mass[i + 1] = mass[i] + std::max(0.0f, kernel[i]) * (std::cos(edgeAngle(i, n)) - std::cos(edgeAngle(i + 1, n)));
  return mass;
}

}  // namespace

double medianSlope(std::span<const float> kernel) {
  const std::vector<double> mass = massOf(kernel);
  if (!(mass.back() > 0)) return 0;
  const auto middle = std::lower_bound(mass.begin(), mass.end(), 0.5 * mass.back());
  return std::tan(0.5 * edgeAngle(static_cast<size_t>(middle - mass.begin()), kernel.size()));
}

StretchedLobe stretchedLobe(std::span<const std::vector<float>> rows) {
  // The squared inverse of an ellipse's radius is a constant and one wave of twice the azimuth.
  StretchedLobe lobe;
  double constant = 0, cosine = 0, sine = 0, smallest = 1e30;
  const double n = static_cast<double>(rows.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    const double slope = medianSlope(rows[i]), azimuth = kTau * static_cast<double>(i) / n;
    if (!(slope > 0)) return {};
    if (slope < smallest) lobe.narrowest = i;
    smallest = std::min(smallest, slope);
    const double inverse = 1 / (slope * slope);
    constant += inverse / n;
    cosine += 2 * inverse * std::cos(azimuth) / n;
    sine += 2 * inverse * std::sin(azimuth) / n;
  }
  const double wave = std::min(std::hypot(cosine, sine), 0.9999 * constant);
  if (wave < 0.01 * constant) return lobe;
  const double stretch = std::sqrt(1 / (constant - wave) - 1 / (constant + wave));
  const double widest = 0.5 * std::atan2(sine, cosine) + kHalfPi;
  lobe.stretch = glm::dvec2(std::cos(widest), std::sin(widest)) * stretch;
  return lobe;
}

float lobeAngle(size_t i, size_t size) {
  const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(size);
  return static_cast<float>(kHalfPi * u * u);
}

std::vector<glm::vec4> lobeSamples(std::span<const float> kernel, int count, int sourceSize) {
  GLINT_CHECK(!kernel.empty() && count > 0, "kernel {} count {}", kernel.size(), count);
  const size_t n = kernel.size();
  const std::vector<double> mass = massOf(kernel);
  const auto edge = [n](size_t i) { return edgeAngle(i, n); };
  std::vector<glm::vec4> samples;
  if (!(mass[n] > 0)) return {glm::vec4(0, 0, 1, 0)};

  const double texel = 4 * 3.14159265358979324 / (6.0 * sourceSize * sourceSize);
  for (int s = 0; s < count; ++s) {
    const double wanted = (s + 0.5) / count * mass[n];
    const size_t i = std::min(
        n - 1, static_cast<size_t>(std::upper_bound(mass.begin(), mass.end(), wanted) - mass.begin()) - 1);
    const double share = mass[i + 1] > mass[i] ? (wanted - mass[i]) / (mass[i + 1] - mass[i]) : 0.5;
    // Uniform in solid angle within the interval.
    const double cosine = std::cos(edge(i)) + share * (std::cos(edge(i + 1)) - std::cos(edge(i)));
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = kTau * std::fmod(s * kGolden, 1.0);
    // Density per steradian: kernel / (2 pi mass).
    const double density = kernel[i] / (kTau * mass[n]);
    const double solidAngle = 1 / (count * std::max(density, 1e-12));
    // A little below the level whose texels would just tile the lobe: above it pictures blur, below it samples leave gaps
    // (measured over nine levels from -1 to 1: see the error that env.prefilter prints).
    const double level = std::max(0.0, 0.5 * std::log2(solidAngle / texel) - 0.25);
    samples.emplace_back(sine * std::cos(phi), sine * std::sin(phi), cosine, level);
  }
  return samples;
}

std::vector<float> lobeDensity(std::span<const float> kernel) {
  const double mass = massOf(kernel).back();
  std::vector<float> density;
  for (const float k : kernel) density.push_back(mass > 0 ? static_cast<float>(std::max(0.0f, k) / (kTau * mass)) : 0.0f);
  return density;
}

}  // namespace glint
