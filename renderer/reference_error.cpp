#include "renderer/reference_error.h"

#include <algorithm>
#include <cmath>

namespace glint {

glm::vec3 errorColor(float share) {
  const float t = std::clamp(share, -1.0f, 1.0f);
  return glm::mix(kErrorColors.none, t < 0 ? kErrorColors.less : kErrorColors.more, std::abs(t));
}

double luminanceOf(const float* rgb) { return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]); }

void ReferenceErrorSum::add(double approximation, double first, double second) {
  const double reference = (first + second) / 2;
  absolute_ += std::abs(approximation - reference);
  noise_ += std::abs(first - second) / 2;
  signed_ += approximation - reference;
  light_ += reference;
  ++pixels_;
}

ReferenceError ReferenceErrorSum::error() const {
  if (pixels_ == 0) return {};
  const double light = std::max(light_, 1e-12 * pixels_);
  return {absolute_ / light, noise_ / light, signed_ / light, pixels_};
}

}  // namespace glint
