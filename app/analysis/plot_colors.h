// Colours of curves: those that the models ask for, as far as each can be told from the ground and from the others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glint {

struct PlotColor {
  uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const PlotColor&) const = default;
};

// Display-referred 0..1 in. On a light ground colours are darkened, on a dark one lightened as far as it takes; one that is
// too near to one before it takes another hue.
std::vector<PlotColor> distinctColors(std::span<const std::array<float, 3>>, bool darkGround);

// `count` steps from one colour, all told from the ground: for curves of one model.
std::vector<PlotColor> colorRamp(const std::array<float, 3>&, size_t count, bool darkGround);

// How far two colours are apart for the eye: the distance in OKLab (Ottosson 2020); 0.02 is just visible side by side.
double colorDistance(PlotColor, PlotColor);

}  // namespace glint
