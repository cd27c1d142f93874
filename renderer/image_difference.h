// How far two pictures are apart: as one number, and pixel by pixel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/image.h"

namespace glint {

enum class DifferenceMetric {
  Flip,  // LDR-FLIP, mean over the picture, 0..1: what a person notices when the two are flipped between
  Rmse,  // root of the mean squared difference of all values
  Max,   // largest absolute difference of a value
};
std::vector<std::string> differenceMetricNames();  // "flip", "rmse", "max"
std::optional<DifferenceMetric> differenceMetric(const std::string& name);

struct Difference {
  double value = 0;         // of the metric
  double largest = 0;       // of `map`
  int x = 0, y = 0;         // where that is, from the top left
  Pixels<float> map;        // one channel: FLIP's error, or the largest absolute difference of the pixel's values
};

// `a` and `b` have one size and three or four finite channels. For Flip they are linear Rec.709 and clamped to
// 0..1, and alpha is ignored; Rmse and Max take the values as they are, alpha included.
Difference imageDifference(const ImageF& a, const ImageF& b, DifferenceMetric);

// LDR-FLIP seen at `pixelsPerDegree`; the default is the authors': a 0.7 m wide 3840-pixel display, 0.7 m away.
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator for Alternating
// Images, HPG 2020.
inline constexpr float kFlipPixelsPerDegree = 67.0206f;
Pixels<float> flip(const ImageF& reference, const ImageF& test, float pixelsPerDegree = kFlipPixelsPerDegree);

// The map in colours, display-referred: black over violet and orange to pale yellow; `white` is the value of the
// last. Equal steps of the value are equal steps for the eye, in grey and for the colour-blind too.
Image8 heatMap(const Pixels<float>& map, float white = 1);

}  // namespace glint
