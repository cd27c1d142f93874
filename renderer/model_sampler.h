// Directions of light drawn in proportion to what a model sends on from them: an importance sampler for any model, from
// its f alone. Tabulated on the device, kept on disk by content; drawing and densities are the host's.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/model_setting.h"

namespace glint {

struct SampledDirection {
  glm::dvec3 light{0, 0, 1};   // unit, above the surface whose normal is +Z
  double pdf = 0;              // per steradian
};

// The sampler for one view of one point of a surface.
class DirectionSampler {
 public:
  // From two numbers in [0, 1).
  SampledDirection sample(double u1, double u2) const;
  // Per steradian, integrates to 1 over the hemisphere; 0 below the surface, positive above it.
  double pdf(const glm::dvec3& light) const;

 private:
  friend class ModelSampler;
  double halfVectorPdf(const glm::dvec3& light) const;  // of the tabulated part; `light` with the view's azimuth at 0

  glm::dvec3 view_{0, 0, 1};            // turned to azimuth 0
  glm::dvec2 turn_{1, 0};               // cos and sin of its azimuth
  double tabulated_ = 0;                // share of the tabulated part; the rest goes by the cosine
  std::vector<double> cumulated_;       // over the cells, from 0 to 1; empty without that part
};

class ModelSampler {
 public:
  // Half vectors by polar angle (as dense for every width of a lobe) and azimuth, for roughnesses and cosines of the view
  // as tableRoughnesses() and tableCosines() of renderer/model_tables.h.
  static constexpr int kRoughnesses = 31, kCosines = 12, kPolar = 32, kAround = 24;

  // Needs a current context. Errors: GLSL that does not compile, at the plugin's own lines.
  static Result<ModelSampler> of(const ModelSetting&, bool diskCache = true);

  // `view` is a unit vector above the surface, in its tangent frame; colours as in Shading.
  DirectionSampler at(const glm::dvec3& view, double roughness, const glm::dvec3& F0, const glm::dvec3& diffuseColor) const;

  // Why there is no table, or not everywhere; empty when all is well. Directions then go by the cosine, which is right
  // but slow: "f is not finite at roughness 0.3, NoV 0.01".
  const std::string& fault() const { return fault_; }

 private:
  struct Lobe {
    std::array<float, size_t{kPolar} * kAround> share;  // of each cell, all together 1
    float black = 0, white = 0;                         // albedo for F0 of 0 and 1; both 0 where it cannot be tabulated
  };
  std::vector<Lobe> lobes_;   // by roughness, then cosine
  std::string fault_;
};

}  // namespace glint
