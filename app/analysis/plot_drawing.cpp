#include "app/analysis/plot_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {

glm::vec2 PlotFrame::place(double xValue, double yValue) const {
  const double u = x.unit(xValue), v = y.unit(yValue);
  if (kind != Polar) return {low.x + static_cast<float>(u) * (high.x - low.x), high.y - static_cast<float>(v) * (high.y - low.y)};
  const double angle = xValue * std::numbers::pi / 180, radius = v * (high.y - low.y);
  return {0.5f * (low.x + high.x) + static_cast<float>(radius * std::sin(angle)), high.y - static_cast<float>(radius * std::cos(angle))};
}

glm::dvec2 PlotFrame::values(glm::vec2 place) const {
  if (kind != Polar) return {x.value((place.x - low.x) / (high.x - low.x)), y.value((high.y - place.y) / (high.y - low.y))};
  const glm::vec2 from{place.x - 0.5f * (low.x + high.x), high.y - place.y};
  return {std::atan2(from.x, from.y) * 180 / std::numbers::pi, y.value(glm::length(from) / (high.y - low.y))};
}

bool PlotFrame::holds(glm::vec2 place) const {
  if (place.x < low.x || place.x > high.x || place.y < low.y || place.y > high.y) return false;
  return kind != Polar || glm::distance(place, {0.5f * (low.x + high.x), high.y}) <= high.y - low.y;
}

std::vector<PlotTextRun> textRuns(const std::string& text) {
  std::vector<PlotTextRun> runs;
  for (size_t at = 0; at < text.size();) {
    const size_t mark = std::min(text.find("_{", at), text.find("^{", at));
    const size_t end = mark == std::string::npos ? mark : text.find('}', mark);
    if (end == std::string::npos) {
      runs.push_back({text.substr(at), 0});
      break;
    }
    if (mark > at) runs.push_back({text.substr(at, mark - at), 0});
    runs.push_back({text.substr(mark + 2, end - mark - 2), text[mark] == '_' ? -1 : 1});
    at = end + 1;
  }
  return runs;
}

std::string withoutMarks(const std::string& text) {
  std::string plain;
  for (const PlotTextRun& run : textRuns(text)) plain += run.text;
  return plain;
}

float textWidth(const std::string& text, float size, bool bold, const TextMeasure& measure) {
  float sum = 0;
  for (const PlotTextRun& run : textRuns(text)) sum += measure(run.text, run.level ? size * kRunSize : size, bold);
  return sum;
}

std::vector<std::vector<glm::vec2>> dashes(const PlotLine& line) {
  if (line.dash.empty() || line.points.size() < 2) return {line.points};
  std::vector<std::vector<glm::vec2>> parts;
  size_t phase = 0;
  float left = line.dash[0];
  std::vector<glm::vec2> part{line.points[0]};
  for (size_t i = 1; i < line.points.size(); ++i) {
    glm::vec2 from = line.points[i - 1];
    const glm::vec2 to = line.points[i];
    for (float length = glm::distance(from, to); length > left; length = glm::distance(from, to)) {
      from += (to - from) * (left / length);
      if (phase % 2 == 0) {
        part.push_back(from);
        parts.push_back(std::move(part));
      }
      part = {from};
      phase = (phase + 1) % line.dash.size();
      left = std::max(line.dash[phase], 0.05f);
    }
    left -= glm::distance(from, to);
    if (phase % 2 == 0) part.push_back(to);
  }
  if (phase % 2 == 0 && part.size() > 1) parts.push_back(std::move(part));
  return parts;
}

}  // namespace glint
