// Places to ask a model for its specular lobe at, so that sums over the directions of light are integrals.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/model_probe.h"

namespace glint {

inline constexpr size_t kLobePoints = 48 * 32;

struct LobeDirection {
  glm::dvec3 light{0, 0, 1};
  double weight = 0;   // solid angle of the light times its cosine; 0 below the horizon
};

// Appends kLobePoints of them, by half vectors that are as dense for every width of a lobe, for a metal seen from `view` (the
// normal is +Z) with one roughness and F0.
void addLobePoints(const glm::dvec3& view, float roughness, float F0, bool analyticLight, std::vector<ProbePoint>& points,
                   std::vector<LobeDirection>& directions);

}  // namespace glint
