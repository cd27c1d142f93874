#include "renderer/quadrature.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace glint {

// By Newton's method from the usual first guess.
std::vector<QuadratureNode> gaussLegendre(int count) {
  std::vector<QuadratureNode> nodes(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
    for (int step = 0; step < 50; ++step) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= count; ++k) p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
      slope = count * (x * p1 - p0) / (x * x - 1);
      const double move = p1 / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    nodes[static_cast<size_t>(i)] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

}  // namespace glint
