// One axis of a plot: from values to 0..1 and back, and where its ticks stand.
#pragma once

#include <string>
#include <vector>

namespace glint {

enum class PlotScale {
  Linear,
  Degrees,   // linear, with ticks at parts of a right angle
  Log,       // low > 0
  LogPlus,   // log(1 + value), which has a zero: of polar plots
};

struct PlotTick {
  double value = 0;
  std::string label;          // empty for a minor one; "10^{-3}" has a raised part (plot_drawing.h)
};

struct PlotAxis {
  double low = 0, high = 1;
  PlotScale scale = PlotScale::Linear;

  double unit(double value) const;       // 0 at low, 1 at high; beyond them outside 0..1; for Log, values <= 0 far below 0
  double value(double unit) const;
  // About `count` labelled ticks within the axis, and for Log minor ones between them.
  std::vector<PlotTick> ticks(int count) const;
  // The same axis with `at` (a unit) staying where it is and everything else `factor` times as close.
  PlotAxis zoomed(double at, double factor) const;
  PlotAxis moved(double units) const;
};

// An axis that holds all of [low, high], ending at round values, of which it has about `steps`. For Log at most
// kMostDecades below the top.
inline constexpr int kMostDecades = 6;
PlotAxis roundAxis(double low, double high, PlotScale, int steps = 9);

// With true minus signs, as wide as the plus: hyphens vanish in print.
std::string withMinus(std::string);

// A value for a person to read, with four digits that count: "0.04321", "3183", "1.6e+06"; with a true minus.
std::string readable(double value);

}  // namespace glint
