// The laws that physics sets a shading model, measured on its own GLSL: what it claims, and what none may break.
#pragma once

#include <span>
#include <vector>

#include "renderer/model_probe.h"

namespace glint {

// The part of a white uniform sky's light that goes to `NoV`: with F0 = 1 for the specular part, a white
// diffuseColor for the diffuse part. By quadrature in half-vector space, good to 2e-3 from roughness 0.05 up.
struct Albedo {
  double specular = 0, diffuse = 0;
};
struct AlbedoQuery {
  float roughness = 0.5f, NoV = 1;
  bool analyticLight = true;
};
std::vector<Albedo> directionalAlbedo(const ModelProbe& ofModel, std::span<const AlbedoQuery>);

// The integral of D (n.h) over the hemisphere, which is 1 for a distribution of normals.
std::vector<double> integralOfD(const ModelProbe& ofModel, std::span<const float> roughness);

// Checks every model's values (finite, not negative; D integrates to 1) and what this one claims (reciprocal,
// energy conserving) over roughness, angles and the range of each parameter. One error a broken law, at the
// model's file, with the worst case and its numbers; errors of GLSL at the plugin's own lines.
Diagnostics checkLaws(const ShadingModel&);

}  // namespace glint
