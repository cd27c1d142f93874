// The linearly transformed cosine (Heitz, Dupuy, Hill and Neubelt 2016) that is nearest to a lobe.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace glint {

// What is sent on of light from one direction above the horizon: f times the cosine. Stands for the mirror image in y too.
struct LobeSample {
  glm::dvec3 direction{0, 0, 1};
  double solidAngle = 0, sent = 0;
};
// The lobe of one view, whose plane is that of x and z; the normal is +Z.
struct CosineFit {
  glm::dmat3 matrix{1};        // from the cosine lobe to the model's
  double above = 1;            // the share of it that is above the horizon
  double distance2 = 0;        // Hellinger's, squared, of what is there from the samples: 0 where they are the same, 2 at most
  bool known = false;          // false: the model sends nothing on
  std::array<double, 4> parameters{};   // of the search
};
// The lobe that is nearest to the samples, by Hellinger's distance, of those that send on as much. The search starts from the
// quartiles of the samples and, when there is one, from the fit of a view close by.
CosineFit fitCosine(const std::vector<LobeSample>&, const CosineFit* close = nullptr);

}  // namespace glint
