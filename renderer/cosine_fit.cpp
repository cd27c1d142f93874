#include "renderer/cosine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace glint {
namespace {

using std::numbers::pi;

// Of values with weights: where that share of all lies below.
double quantile(const std::vector<std::pair<double, double>>& sorted, double share) {
  double all = 0, below = 0;
  for (const auto& [value, weight] : sorted) all += weight;
  for (const auto& [value, weight] : sorted) {
    below += weight;
    if (below >= share * all) return value;
  }
  return sorted.empty() ? 0 : sorted.back().first;
}

// The angle of the lobe from the normal, the logarithms of its two widths, and how far its middle is shifted along the plane.
using Parameters = std::array<double, 4>;

glm::dmat3 matrixOf(const Parameters& p) {
  const glm::dvec3 Z(std::sin(p[0]), 0, std::cos(p[0])), X(Z.z, 0, -Z.x);
  return {X * std::exp(p[1]), glm::dvec3(0, std::exp(p[2]), 0), Z + X * p[3]};
}

// Of a cosine lobe through that matrix: the horizon is a plane there too.
double shareAbove(const glm::dmat3& matrix) {
  const glm::dvec3 normal(matrix[0].z, matrix[1].z, matrix[2].z);
  return 0.5 + 0.5 * normal.z / glm::length(normal);
}

// Where a lobe has its quartiles, a cosine lobe has them at 0 and one over the root of 3 each way, on the plane at distance 1.
Parameters byQuartiles(const std::vector<LobeSample>& samples) {
  glm::dvec3 sum(0);
  for (const LobeSample& s : samples) sum += s.solidAngle * s.sent * glm::dvec3(s.direction.x, 0, s.direction.z);
  const glm::dvec3 Z = glm::normalize(sum), X(Z.z, 0, -Z.x);
  constexpr double kFar = 1e9;
  std::vector<std::pair<double, double>> x, y;
  for (const LobeSample& s : samples) {
    const double weight = s.solidAngle * s.sent, along = glm::dot(s.direction, Z), across = glm::dot(s.direction, X);
    if (!(weight > 0)) continue;
    const bool before = along > 1e-6;
    x.emplace_back(before ? across / along : std::copysign(kFar, across), weight);
    y.emplace_back(before ? std::abs(s.direction.y) / along : kFar, weight);
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  const double quartile = 1 / std::sqrt(3.0);
  constexpr double kNarrowest = 1e-5, kWidest = 1e3;
  return {std::atan2(Z.x, Z.z), std::log(std::clamp((quantile(x, 0.75) - quantile(x, 0.25)) / (2 * quartile), kNarrowest, kWidest)),
          std::log(std::clamp(quantile(y, 0.5) / quartile, kNarrowest, kWidest)), std::clamp(quantile(x, 0.5), -kWidest, kWidest)};
}

// The search: Levenberg's and Marquardt's, over the differences of the roots of what is sent on.
class Search {
 public:
  Search(const std::vector<LobeSample>& samples, double all) {
    for (const LobeSample& s : samples) {
      points_.push_back({s.direction.x, s.direction.y * s.direction.y, s.direction.z, std::sqrt(s.solidAngle), std::sqrt(s.sent * s.solidAngle / all)});
    }
    residuals_.resize(points_.size());
    for (auto& column : slopes_) column.resize(points_.size());
  }

  // The sum of their squares.
  double differences(const Parameters& p, std::vector<double>& out) const {
    const glm::dmat3 m = matrixOf(p);
    const double plane = m[0].x * m[2].z - m[2].x * m[0].z, wide = m[1].y, share = shareAbove(m);
    const double xx = m[2].z / plane, xz = -m[2].x / plane, zx = -m[0].z / plane, zz = m[0].x / plane, yy = 1 / (wide * wide);
    const double scale = std::sqrt(1 / (pi * std::abs(plane) * wide * std::max(share, 1e-6)));
    double sum = 0;
    for (size_t i = 0; i < points_.size(); ++i) {
      const Point& s = points_[i];
      const double x = xx * s.x + xz * s.z, z = zx * s.x + zz * s.z;
      const double d = s.root - s.extent * scale * std::sqrt(std::max(z, 0.0)) / (x * x + s.y2 * yy + z * z);
      out[i] = d;
      sum += d * d;
    }
    return sum;
  }

  // Improves the parameters; returns what their differences are then.
  double improve(Parameters& p) {
    double best = differences(p, residuals_), damping = 1e-3;
    for (int step = 0; step < 24; ++step) {
      for (size_t k = 0; k < p.size(); ++k) {
        constexpr double kStep = 1e-5;
        Parameters moved = p;
        moved[k] += kStep;
        differences(moved, slopes_[k]);
        for (size_t i = 0; i < residuals_.size(); ++i) slopes_[k][i] = (slopes_[k][i] - residuals_[i]) / kStep;
      }
      glm::dmat4 normal(0);
      glm::dvec4 right(0);
      for (int a = 0; a < 4; ++a)
        for (size_t i = 0; i < residuals_.size(); ++i) {
          right[a] -= slopes_[size_t(a)][i] * residuals_[i];
          for (int b = 0; b <= a; ++b) normal[a][b] += slopes_[size_t(a)][i] * slopes_[size_t(b)][i];
        }
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) normal[a][b] = normal[b][a];
      bool better = false;
      for (int attempt = 0; attempt < 8 && !better; ++attempt) {
        glm::dmat4 damped = normal;
        for (int a = 0; a < 4; ++a) damped[a][a] += damping * normal[a][a] + 1e-12;
        const glm::dvec4 change = glm::inverse(damped) * right;
        Parameters next = p;
        for (int a = 0; a < 4; ++a) next[size_t(a)] += std::clamp(change[a], -0.5, 0.5);
        const double value = differences(next, slopes_[0]);
        better = value < best;
        damping *= better ? 0.2 : 6;
        if (!better) continue;
        const double gained = best - value;
        p = next;
        best = value;
        std::swap(residuals_, slopes_[0]);
        if (gained < 1e-4 * best + 1e-9) return best;
      }
      if (!better) break;
    }
    return best;
  }

 private:
  struct Point {
    double x, y2, z, extent, root;
  };
  std::vector<Point> points_;
  std::vector<double> residuals_;
  std::array<std::vector<double>, 4> slopes_;
};

}  // namespace

CosineFit fitCosine(const std::vector<LobeSample>& samples, const CosineFit* close) {
  double all = 0;
  for (const LobeSample& s : samples) all += s.solidAngle * s.sent;
  if (!(all > 0) || !std::isfinite(all)) return {};
  Search search(samples, all);
  Parameters p = byQuartiles(samples);
  CosineFit fit;
  if (close && close->known) {
    std::vector<double> spare(samples.size());
    if (search.differences(close->parameters, spare) < search.differences(p, spare)) p = close->parameters;
  }
  fit.distance2 = search.improve(p);
  fit.parameters = p;
  fit.matrix = matrixOf(p);
  fit.above = shareAbove(fit.matrix);
  fit.known = true;
  return fit;
}

}  // namespace glint
