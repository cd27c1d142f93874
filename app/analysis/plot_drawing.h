// A plot as it is drawn, by whoever draws: into SVG, into a picture, onto the editor's window. Made once by
// plot_layout.h, so that all of them look alike.
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/analysis/plot_axis.h"
#include "app/analysis/plot_colors.h"
#include "app/text_painter.h"
#include "renderer/image.h"

namespace glint {

// Positions are pixels from the top left corner; a line through x + 0.5 is sharp.
struct PlotLine {
  std::vector<glm::vec2> points;
  float width = 1;
  PlotColor color;
  std::vector<float> dash;     // lengths drawn and left out in turn; ends are round; empty: a whole line
};
struct PlotRect {
  glm::vec2 low{0}, high{0};
  PlotColor color;
};
struct PlotText {
  glm::vec2 at{0};             // of the baseline: its left, centre or right
  float size = 12;
  bool bold = false;
  PlotColor color;
  TextAlign align = TextAlign::Left;
  std::string text;            // "_{h}" is lowered, "^{2}" raised, both smaller
};
struct PlotBitmap {
  glm::vec2 low{0}, high{0};
  Image8 pixels;
};
using PlotItem = std::variant<PlotRect, PlotLine, PlotText, PlotBitmap>;

// Where values are drawn, and how a place there is read.
struct PlotFrame {
  enum Kind { Cartesian, Polar, Slice } kind = Cartesian;
  glm::vec2 low{0}, high{0};   // of a polar plot, whose origin is the middle of the lower edge, the half disc's
  PlotAxis x, y;               // of a polar plot the angle, -90 degrees on the left, and the radius
  size_t slice = 0;            // which of PlotData::slices

  glm::vec2 place(double xValue, double yValue) const;      // may lie outside
  glm::dvec2 values(glm::vec2 place) const;
  bool holds(glm::vec2 place) const;
};

// Who a legend's entry stands for.
struct PlotLegendEntry {
  size_t subject = 0;
  glm::vec2 low{0}, high{0};
};

struct PlotDrawing {
  glm::ivec2 size{0};
  std::string title, description;      // in words, for who cannot see it
  PlotColor ground;
  std::vector<PlotItem> items;         // the first lies lowest
  std::vector<PlotFrame> frames;
  std::vector<PlotLegendEntry> legend;
  std::vector<PlotColor> colors;       // of PlotData::curves, in their order
};

// The pieces of a text between its marks.
struct PlotTextRun {
  std::string text;
  int level = 0;               // -1 lowered, 1 raised
};
std::vector<PlotTextRun> textRuns(const std::string&);
std::string withoutMarks(const std::string&);     // "\u03b8_{h}" as "\u03b8h"
// Of runs that are not level: their size, and how far their baseline moves, in sizes of the text.
inline constexpr float kRunSize = 0.8f, kLowered = 0.2f, kRaised = -0.36f;

// The width of a text without marks.
using TextMeasure = std::function<float(const std::string&, float size, bool bold)>;
float textWidth(const std::string&, float size, bool bold, const TextMeasure&);

// A line's dashes as lines of their own.
std::vector<std::vector<glm::vec2>> dashes(const PlotLine&);

}  // namespace glint
