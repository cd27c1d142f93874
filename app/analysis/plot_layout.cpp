#include "app/analysis/plot_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/analysis/plot_layout_parts.h"

namespace glint {

using plot_layout::Sheet;

namespace {

// Whether the two sides of the normal are told apart.
bool twoSided(const PlotSettings& s) {
  if (s.kind == PlotKind::G || s.kind == PlotKind::V) return std::any_of(s.angles.begin(), s.angles.end(), [](float a) { return a != 0; });
  return s.kind == PlotKind::D || s.kind == PlotKind::Lobe || s.kind == PlotKind::Polar;
}

PlotAxis wholeX(const PlotSettings& s) {
  if (s.kind == PlotKind::Albedo && s.overRoughness) return {0, 1, PlotScale::Linear};
  return {twoSided(s) ? -90.0 : 0.0, 90, PlotScale::Degrees};
}

PlotAxis wholeY(const PlotData& data) {
  const PlotSettings& s = data.settings;
  double low = std::numeric_limits<double>::infinity(), high = -low, least = low;
  for (const PlotCurve& curve : data.curves)
    for (const double y : curve.y) {
      if (!std::isfinite(y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
      if (y > 0) least = std::min(least, y);
    }
  if (!(low <= high)) low = 0, high = least = 1;
  if (data.top) high = std::min(high, *data.top);
  if (s.most) high = *s.most;
  if (s.kind == PlotKind::Polar) {
    PlotAxis axis = s.most ? PlotAxis{0, high, PlotScale::Linear} : roundAxis(0, high, PlotScale::Linear, 4);
    if (s.log) axis.scale = PlotScale::LogPlus;
    return axis;
  }
  if (s.log) {
    PlotAxis axis = roundAxis(std::min(least, high), high, PlotScale::Log);
    if (s.most) axis.high = high;
    return axis;
  }
  if (s.most) return {std::min(low, 0.0), high, PlotScale::Linear};
  // What is a fraction ends at 1, where that cuts nothing off.
  const bool fraction = s.kind == PlotKind::F || s.kind == PlotKind::G || s.kind == PlotKind::Albedo;
  if (fraction && high <= 1.001) high = 1;
  return roundAxis(std::min(low, 0.0), high, PlotScale::Linear);
}

// The curve cut to the frame in units of its axes, gaps left out, on the drawing's pixels.
std::vector<std::vector<glm::vec2>> cut(const PlotCurve& curve, const PlotFrame& frame) {
  std::vector<std::vector<glm::vec2>> parts;
  std::vector<glm::vec2> part;
  const auto finish = [&] {
    if (part.size() > 1) parts.push_back(std::move(part));
    part.clear();
  };
  const auto place = [&](const glm::dvec2& unit) { return frame.place(frame.x.value(unit.x), frame.y.value(unit.y)); };
  const auto unit = [&](size_t i) { return glm::dvec2(frame.x.unit(curve.x[i]), frame.y.unit(curve.y[i])); };
  for (size_t i = 1; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.y[i]) || !std::isfinite(curve.y[i - 1])) {
      finish();
      continue;
    }
    // Liang and Barsky 1984.
    const glm::dvec2 a = unit(i - 1), d = unit(i) - a;
    double from = 0, to = 1;
    for (int k = 0; k < 2; ++k)
      for (const double side : {0.0, 1.0}) {
        // A little beyond the value's ends, so that a curve at 1 is not cut in pieces by its last digit.
        const double more = k == 1 ? 0.004 : 0, p = side == 0 ? -d[k] : d[k], q = (side == 0 ? a[k] : 1 - a[k]) + more;
        if (p == 0) {
          if (q < 0) to = -1;
        } else if (p < 0) {
          from = std::max(from, q / p);
        } else {
          to = std::min(to, q / p);
        }
      }
    if (from >= to) {
      finish();
      continue;
    }
    if (from > 0) finish();
    if (part.empty()) part.push_back(place(a + from * d));
    part.push_back(place(a + to * d));
    if (to < 1) finish();
  }
  finish();
  return parts;
}

// Whether one would hide the other, on this frame.
bool coincide(const PlotCurve& a, const PlotCurve& b, const PlotFrame& frame) {
  if (a.x != b.x) return false;
  for (size_t i = 0; i < a.y.size(); ++i) {
    if (frame.x.unit(a.x[i]) < 0 || frame.x.unit(a.x[i]) > 1) continue;
    if (std::isfinite(a.y[i]) != std::isfinite(b.y[i])) return false;
    const auto unit = [&](double y) { return std::clamp(frame.y.unit(y), 0.0, 1.0); };
    if (std::isfinite(a.y[i]) && std::abs(unit(a.y[i]) - unit(b.y[i])) > 0.002) return false;
  }
  return true;
}

void drawCurves(Sheet& sheet, const PlotFrame& frame) {
  const auto& curves = sheet.data.curves;
  for (size_t i = curves.size(); i-- > 0;) {   // the first named lies on top
    if (sheet.view.hidden.count(curves[i].subject)) continue;
    std::vector<float> dash;
    if (sheet.dashed) dash = dashOf(curves[i].variant, sheet.unit);
    if (dash.empty()) {
      // Curves that lie on one another share the line, each with its own piece of it.
      size_t above = 0, below = 0;
      for (size_t k = 0; k < curves.size(); ++k)
        if (k != i && !sheet.view.hidden.count(curves[k].subject) && coincide(curves[i], curves[k], frame)) ++(k < i ? above : below);
      const float piece = sheet.px(12);
      if (below > 0) dash = {piece * static_cast<float>(above + 1), piece * static_cast<float>(below)};
    }
    for (auto& part : cut(curves[i], frame)) sheet.line(std::move(part), 2, sheet.drawing.colors[i], dash);
  }
}

// Where a mirror would send what comes from the view's side.
std::vector<double> mirrors(const PlotSettings& s) {
  std::vector<double> angles;
  if ((s.kind != PlotKind::Lobe && s.kind != PlotKind::Polar) || s.out != 0) return angles;
  for (const float a : s.angles) angles.push_back(a);
  return angles;
}

void drawCartesian(Sheet& sheet, float top) {
  const PlotSettings& s = sheet.data.settings;
  PlotFrame frame{PlotFrame::Cartesian, {}, {}, sheet.view.x.value_or(wholeX(s)), sheet.view.y.value_or(wholeY(sheet.data)), 0};
  const float width = static_cast<float>(sheet.view.size.x), height = static_cast<float>(sheet.view.size.y);
  frame.low.y = std::round(top + sheet.px(26)) + 0.5f;
  frame.high.y = std::round(height - sheet.px(52)) + 0.5f;
  const auto yTicks = frame.y.ticks(std::max(2, static_cast<int>((frame.high.y - frame.low.y) / sheet.px(46))));
  float labels = 0;
  for (const PlotTick& tick : yTicks) labels = std::max(labels, sheet.width(tick.label, 12));
  frame.low.x = std::round(sheet.margin() + labels + sheet.px(8)) + 0.5f;
  frame.high.x = std::round(width - sheet.margin() - sheet.px(6)) + 0.5f;
  if (frame.high.x - frame.low.x < 10 || frame.high.y - frame.low.y < 10) return;
  const auto xTicks = frame.x.ticks(std::max(2, static_cast<int>((frame.high.x - frame.low.x) / sheet.px(64))));

  for (const PlotTick& tick : yTicks) {
    const float y = std::round(frame.place(frame.x.low, tick.value).y) + 0.5f;
    sheet.line({{frame.low.x, y}, {frame.high.x, y}}, 1, tick.label.empty() ? sheet.faint : sheet.grid);
    sheet.text({frame.low.x - sheet.px(8), y + sheet.px(4)}, 12, false, sheet.dim, TextAlign::Right, tick.label);
  }
  for (const PlotTick& tick : xTicks) {
    const float x = std::round(frame.place(tick.value, frame.y.low).x) + 0.5f;
    sheet.line({{x, frame.low.y}, {x, frame.high.y}}, 1, sheet.grid);
    sheet.text({x, frame.high.y + sheet.px(17)}, 12, false, sheet.dim, TextAlign::Center, tick.label);
  }
  // The axes themselves, where they are zero, and the most that may come back.
  sheet.line({{frame.low.x, frame.high.y}, {frame.high.x, frame.high.y}}, 1, sheet.axis);
  if (frame.x.low < 0 && frame.x.high > 0) {
    const float x = std::round(frame.place(0, frame.y.low).x) + 0.5f;
    sheet.line({{x, frame.low.y}, {x, frame.high.y}}, 1, sheet.axis);
  }
  if (s.kind == PlotKind::Albedo && frame.y.unit(1) > 0 && frame.y.unit(1) < 0.999) {
    const float y = std::round(frame.place(0, 1).y) + 0.5f;
    sheet.line({{frame.low.x, y}, {frame.high.x, y}}, 1, sheet.axis);
  }
  for (const double angle : mirrors(s)) {
    if (frame.x.unit(angle) <= 0 || frame.x.unit(angle) >= 1 || angle == 0) continue;
    const float x = std::round(frame.place(angle, frame.y.low).x) + 0.5f;
    sheet.line({{x, frame.low.y}, {x, frame.high.y}}, 1, sheet.dim, {sheet.px(3), sheet.px(4)});
    if (mirrors(s).size() == 1) sheet.text({x, frame.low.y - sheet.px(6)}, 12, false, sheet.dim, TextAlign::Center, "mirror");
  }
  drawCurves(sheet, frame);
  sheet.text({frame.low.x, frame.low.y - sheet.px(8)}, 12, false, sheet.ink, TextAlign::Left, yTitle(s));
  sheet.text({0.5f * (frame.low.x + frame.high.x), frame.high.y + sheet.px(39)}, 12, false, sheet.ink, TextAlign::Center, xTitle(s));
  sheet.drawing.frames.push_back(frame);
}

std::vector<glm::vec2> arc(const PlotFrame& frame, double radius) {
  std::vector<glm::vec2> points;
  for (int i = 0; i <= 120; ++i) points.push_back(frame.place(-90 + 1.5 * i, radius));
  return points;
}

void drawPolar(Sheet& sheet, float top) {
  const PlotSettings& s = sheet.data.settings;
  PlotFrame frame{PlotFrame::Polar, {}, {}, {-90, 90, PlotScale::Degrees}, sheet.view.y.value_or(wholeY(sheet.data)), 0};
  const float width = static_cast<float>(sheet.view.size.x), height = static_cast<float>(sheet.view.size.y);
  const float bottom = std::round(height - sheet.px(52)) + 0.5f;
  const float radius = std::min(0.5f * width - sheet.margin() - sheet.px(34), bottom - top - sheet.px(30));
  if (radius < 10) return;
  frame.low = {0.5f * width - radius, bottom - radius};
  frame.high = {0.5f * width + radius, bottom};
  const auto ticks = frame.y.ticks(std::max(2, static_cast<int>(radius / sheet.px(60))));
  for (const PlotTick& tick : ticks)
    if (tick.value > frame.y.low) sheet.line(arc(frame, tick.value), 1, tick.label.empty() ? sheet.faint : sheet.grid);
  sheet.line(arc(frame, frame.y.high), 1, sheet.grid);
  for (int angle = -90; angle <= 90; angle += 15) {
    sheet.line({frame.place(angle, frame.y.low), frame.place(angle, frame.y.high)}, 1, angle % 30 ? sheet.faint : angle ? sheet.grid : sheet.axis);
    if (angle % 30) continue;
    const glm::vec2 rim = frame.place(angle, frame.y.high), out = glm::normalize(rim - frame.place(0, frame.y.low));
    const TextAlign align = angle < 0 ? TextAlign::Right : angle > 0 ? TextAlign::Left : TextAlign::Center;
    const float drop = std::abs(angle) == 90 ? sheet.px(4) : angle == 0 ? 0 : sheet.px(3);
    sheet.text(rim + out * sheet.px(7) + glm::vec2(0, drop), 12, false, sheet.dim, align, fmt::format("{}{}\u00b0", angle < 0 ? "\u2212" : "", std::abs(angle)));
  }
  sheet.line({frame.place(-90, frame.y.high), frame.place(90, frame.y.high)}, 1, sheet.axis);
  float lastLabel = -1e9f;
  for (const PlotTick& tick : ticks) {
    const float x = frame.place(90, tick.value).x;
    const float half = 0.5f * sheet.width(tick.label, 12);
    if (tick.label.empty() || x - half < lastLabel + sheet.px(6)) continue;
    sheet.text({x, bottom + sheet.px(17)}, 12, false, sheet.dim, TextAlign::Center, tick.label);
    lastLabel = x + half;
  }
  // Where the view stands, and where a mirror would have the light.
  float labelled = -90;
  for (const float angle : s.angles) {
    if (s.out != 0 || angle == 0) continue;
    sheet.line({frame.place(-angle, frame.y.low), frame.place(-angle, frame.y.high)}, 1.5f, sheet.dim);
    sheet.line({frame.place(angle, frame.y.low), frame.place(angle, frame.y.high)}, 1, sheet.dim, {sheet.px(3), sheet.px(4)});
    // Of lines that are close together one has the words.
    if (std::abs(angle - labelled) < 10) continue;
    labelled = angle;
    // The words stand outside, beyond the degrees.
    for (const double at : {-static_cast<double>(angle), static_cast<double>(angle)}) {
      const glm::vec2 rim = frame.place(at, frame.y.high), out = glm::normalize(rim - frame.place(0, frame.y.low));
      const bool taken = std::fmod(std::abs(at), 30.0) < 7 || std::fmod(std::abs(at), 30.0) > 23;
      // At the sides there is no room outside: above the horizon, inside.
      const bool flat = std::abs(at) > 75;
      const TextAlign outside = at < 0 ? TextAlign::Right : TextAlign::Left, inside = at < 0 ? TextAlign::Left : TextAlign::Right;
      sheet.text(flat ? rim - out * sheet.px(6) - glm::vec2(0, sheet.px(7)) : rim + out * sheet.px(taken ? 44 : 8) + glm::vec2(0, sheet.px(3)), 12, false,
                 sheet.dim, flat ? inside : outside, at < 0 ? "view" : "mirror");
    }
  }
  drawCurves(sheet, frame);
  sheet.text({0.5f * width, bottom + sheet.px(39)}, 12, false, sheet.ink, TextAlign::Center, yTitle(s) + ", over " + xTitle(s));
  sheet.drawing.frames.push_back(frame);
}

std::string describe(const PlotData& data) {
  std::string text = withoutMarks(plotTitle(data.settings) + ": " + plotConditions(data) + ". ");
  for (size_t i = 0; i < data.titles.size(); ++i) text += (i ? "; " : "Models: ") + data.titles[i];
  return text + ".";
}

}  // namespace

float plotUnit(glm::ivec2 size) {
  return std::clamp(std::min(static_cast<float>(size.x) / 900, static_cast<float>(size.y) / 600), 0.75f, 8.0f);
}

std::vector<float> dashOf(size_t variant, float unit) {
  static const std::vector<float> kPatterns[] = {{}, {7, 5}, {0.1f, 4.5f}, {9, 5, 0.1f, 5}, {14, 6}, {4, 4}, {9, 4.5f, 0.1f, 4.5f, 0.1f, 4.5f}};
  std::vector<float> dash = kPatterns[variant % std::size(kPatterns)];
  for (float& length : dash) length *= unit;
  return dash;
}

PlotDrawing layOutPlot(const PlotData& data, const PlotView& view, const TextMeasure& measure) {
  Sheet sheet(data, view, measure);
  sheet.drawing.title = withoutMarks(plotTitle(data.settings));
  sheet.drawing.description = describe(data);
  const float top = sheet.drawHead();
  if (data.settings.kind == PlotKind::Slice) plot_layout::drawSlices(sheet, top);
  else if (data.settings.kind == PlotKind::Polar) drawPolar(sheet, top);
  else drawCartesian(sheet, top);
  return std::move(sheet.drawing);
}

}  // namespace glint
