// What a plot says at a place: for whoever points at it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/analysis/plot_data.h"
#include "app/analysis/plot_drawing.h"

namespace glint {

struct PlotReading {
  size_t frame = 0;                   // which of PlotDrawing::frames
  std::string place;                  // "\u03b8_{h} 12.3\u00b0"
  double x = 0, y = 0;                // the place in the axes' values; y counts for slices
  struct Line {
    size_t subject = 0;
    std::string title;                // "GGX, 45\u00b0"
    PlotColor color;
    double value = 0;                 // of the curve at x, or of the slice; not finite where there is none
    glm::vec2 dot{0};                 // where that is in the drawing; of curves
  };
  std::vector<Line> lines;            // of what is not hidden, the largest value first for curves
};

// Nothing outside the frames.
std::optional<PlotReading> readPlot(const PlotData&, const PlotDrawing&, glm::vec2 place, const std::set<size_t>& hidden = {});

// A curve's value between its points; not finite beyond its ends and in its gaps.
double valueAt(const PlotCurve&, double x);

}  // namespace glint
