// From the numbers of a plot to its drawing: axes, ticks, curves, legend, all of it once for every renderer.
#pragma once

#include <optional>
#include <set>

#include "app/analysis/plot_data.h"
#include "app/analysis/plot_drawing.h"

namespace glint {

// How it is looked at. Sizes are pixels.
struct PlotView {
  glm::ivec2 size{900, 600};
  float unit = 1;                          // pixels a unit of text: 12 of them are the ticks' size
  std::optional<PlotAxis> x, y;            // instead of the whole
  std::set<size_t> hidden;                 // subjects that are not drawn, their entries in the legend dim
  bool title = true;                       // else the drawing begins with its legend
  std::optional<PlotColor> ground;         // instead of the settings' own
};

// The unit of a picture of that size: text grows with it.
float plotUnit(glm::ivec2 size);

PlotDrawing layOutPlot(const PlotData&, const PlotView&, const TextMeasure&);

// What the curves are drawn with: 0 a whole line, then dashes, dots and so on.
std::vector<float> dashOf(size_t variant, float unit);

// Words for titles: what the plot is of, and under which conditions ("roughness 0.5, F0 0.04").
std::string plotTitle(const PlotSettings&);
std::string plotConditions(const PlotData&);
// The two axes, with their units: "\u03b8_{l}, light from the normal", "f, 1/sr".
std::string xTitle(const PlotSettings&);
std::string yTitle(const PlotSettings&);

}  // namespace glint
