// The Monte Carlo reference at single points of a surface, and the approximations that the fast path has of the same
// light, through the GLSL that draws: for numbers (evaluation.h). Needs a current context.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "renderer/environment_lighting.h"
#include "renderer/environment_sampler.h"
#include "renderer/light.h"

namespace glint {

class ReferenceProbe {
 public:
  static constexpr int kLightSamples = 131072, kEnvironmentSamples = 262144;   // of each number

  struct Point {                            // at the origin
    glm::dvec3 normal{0, 0, 1}, view{0, 0, 1};
    double roughness = 0.5;
    glm::vec3 F0{1};
  };

  // What the specular part of a model sends to the viewer of a light with a surface, without its window where that is
  // far away. Errors, here and below: GLSL that does not compile, values that are not finite.
  Result<glm::dvec3> light(const ModelSetting&, const Light&, const Point&);
  // What arrives of it.
  Result<double> irradiance(const Light&, const Point&);
  // Of an environment; null: white light from all sides.
  Result<glm::dvec3> environment(const ModelSetting&, const EnvironmentSampler*, const Point&);

  // What Karis 2013 has for light(): the middle as a point light, and the representative point with its lobe widened in D
  // alone, as it is, by factor 3 and 2, with the cosine of that point, with eq. 11 as printed, with half a tube's length,
  // with eq. 18 instead of 19.
  enum Approximation { CenterPoint, SpecularD, Plain, Factor3, Factor2, OwnCosine, AsPrinted, HalfLength, SmallestAngle, kApproximations };
  Result<std::array<glm::dvec3, kApproximations>> approximations(const ModelSetting&, const Light&, const Point&);

 private:
  Result<const gl::Program*> program(const ModelSetting&, const char* what, const Point&);
  static void setLight(const gl::Program&, const Light&);
  Result<glm::dvec3> mean(const gl::Program&, int samples);

  Rectangles rectangles_;
  ProgramCache programs_;
  EnvironmentLighting lighting_{programs_, rectangles_, true};
};

}  // namespace glint
