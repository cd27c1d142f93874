// How far approximated light is from the reference: what the error view shows, and its numbers.
#pragma once

#include <glm/glm.hpp>

namespace glint {

// The luminance of the approximation less that of the reference, relative to the reference, as a colour: from `less`
// (darker by RenderSettings::errorScale and more) over `none` to `more`. Where the reference is darker than kErrorFloor of
// what a display shows as white, the error is relative to that. All colours are linear Rec.709.
inline constexpr const char* kErrorView = "error";
struct ErrorColors {
  glm::vec3 less{0.03f, 0.2f, 0.9f}, none{0.16f}, more{0.95f, 0.25f, 0.01f}, noSurface{0.0176f};
};
inline constexpr ErrorColors kErrorColors;
inline constexpr float kErrorFloor = 1e-3f;
// The colour of a relative error that is `share` of the scale.
glm::vec3 errorColor(float share);

// Of linear Rec.709.
double luminanceOf(const float* rgb);

// Over the pixels that surfaces cover as a whole, each a part of the reference's mean luminance there.
struct ReferenceError {
  double mean = 0;     // the mean of the differences, all counted as positive
  double noise = 0;    // what that would be of a perfect approximation, as the reference has not converged
  double light = 0;    // the mean difference: above 0, too much light comes back
  int pixels = 0;      // 0: nothing is seen, and the others say nothing
};

// Adds up pixels for it. The reference comes as two averages of as many different samples: half of their difference is
// spread as their mean is about the truth.
class ReferenceErrorSum {
 public:
  void add(double approximation, double first, double second);
  ReferenceError error() const;

 private:
  double absolute_ = 0, noise_ = 0, signed_ = 0, light_ = 0;
  int pixels_ = 0;
};

}  // namespace glint
