// Nodes and weights for integrals over an interval.
#pragma once

#include <vector>

namespace glint {

struct QuadratureNode {
  double x, weight;
};

// Gauss and Legendre's on (0, 1): exact for polynomials of degree 2 count - 1.
std::vector<QuadratureNode> gaussLegendre(int count);

}  // namespace glint
