// The paper that plot_layout.cpp and its parts draw on.
#pragma once

#include <cmath>

#include "app/analysis/plot_layout.h"

namespace glint::plot_layout {

struct Sheet {
  Sheet(const PlotData&, const PlotView&, const TextMeasure&);

  const PlotData& data;
  const PlotView& view;
  const TextMeasure& measure;
  PlotDrawing drawing;
  float unit;
  bool dashed = false;                 // variants are told apart by dashes; else by colours
  PlotColor ink, dim, axis, grid, faint;

  float px(float units) const { return std::round(units * unit); }
  float margin() const { return px(18); }
  float width(const std::string& text, float size, bool bold = false) const { return textWidth(text, std::round(size * unit), bold, measure); }

  void line(std::vector<glm::vec2> points, float width, PlotColor, std::vector<float> dash = {});
  void text(glm::vec2 at, float size, bool bold, PlotColor, TextAlign, const std::string&);
  void bitmap(glm::vec2 low, glm::vec2 high, Image8);
  // The text, or its beginning and an ellipsis.
  std::string fitted(const std::string&, float size, bool bold, float room) const;

  // Title, conditions, legend and notes; gives the height they end at.
  float drawHead();

 private:
  float drawLegend(float y);
};

// The image slices side by side, with their scale.
void drawSlices(Sheet&, float top);

}  // namespace glint::plot_layout
