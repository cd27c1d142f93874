#include "app/analysis/plot_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/analysis/plot_layout.h"

namespace glint {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The sign of an axis without its words: "\u03b8_{h}" of "\u03b8_{h}, half vector from the normal".
std::string signOf(const std::string& title) { return title.substr(0, title.find(',')); }

double valueAt(const PlotSlice& slice, double thetaH, double thetaD, PlotChannel channel) {
  const int x = std::clamp(static_cast<int>(thetaH / 90 * slice.f.width), 0, slice.f.width - 1);
  const int y = std::clamp(static_cast<int>((1 - thetaD / 90) * slice.f.height), 0, slice.f.height - 1);
  const float* f = slice.f.at(x, y);
  return channelValue({f[0], f[1], f[2]}, channel);
}

}  // namespace

double valueAt(const PlotCurve& curve, double x) {
  if (curve.x.empty() || x < curve.x.front() || x > curve.x.back()) return kNone;
  const size_t right = std::max<size_t>(1, static_cast<size_t>(std::lower_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin()));
  if (right >= curve.x.size()) return curve.y.back();
  const double t = (x - curve.x[right - 1]) / (curve.x[right] - curve.x[right - 1]);
  // At a point itself its neighbour, which may be a gap, does not matter.
  if (t == 0) return curve.y[right - 1];
  if (t == 1) return curve.y[right];
  return curve.y[right - 1] + t * (curve.y[right] - curve.y[right - 1]);
}

std::optional<PlotReading> readPlot(const PlotData& data, const PlotDrawing& drawing, glm::vec2 place, const std::set<size_t>& hidden) {
  for (size_t i = 0; i < drawing.frames.size(); ++i) {
    const PlotFrame& frame = drawing.frames[i];
    if (!frame.holds(place)) continue;
    const glm::dvec2 at = frame.values(place);
    PlotReading reading{i, {}, at.x, at.y, {}};
    if (frame.kind == PlotFrame::Slice) {
      reading.place = fmt::format("\u03b8_{{h}} {:.1f}\u00b0, \u03b8_{{d}} {:.1f}\u00b0", at.x, at.y);
      // Every model at the same place, to be compared.
      for (const PlotSlice& slice : data.slices) {
        const std::string& title = data.titles[slice.subject];
        if (data.settings.channel != PlotChannel::Rgb) {
          reading.lines.push_back({slice.subject, title, {}, valueAt(slice, at.x, at.y, data.settings.channel), {}});
          continue;
        }
        for (const PlotChannel channel : {PlotChannel::Red, PlotChannel::Green, PlotChannel::Blue})
          reading.lines.push_back({slice.subject, fmt::format("{}, {}", title, name(channel)), {}, valueAt(slice, at.x, at.y, channel), {}});
      }
      return reading;
    }
    const std::string sign = signOf(xTitle(data.settings));
    reading.place = frame.x.scale == PlotScale::Degrees ? withMinus(fmt::format("{} {:.1f}\u00b0", sign, at.x)) : fmt::format("{} {:.3f}", sign, at.x);
    for (size_t k = 0; k < data.curves.size(); ++k) {
      const PlotCurve& curve = data.curves[k];
      if (hidden.count(curve.subject)) continue;
      const std::string& variant = data.variants[curve.variant];
      const double value = valueAt(curve, at.x);
      reading.lines.push_back({curve.subject, data.titles[curve.subject] + (variant.empty() ? "" : ", " + variant), drawing.colors[k], value,
                               std::isfinite(value) ? frame.place(at.x, value) : glm::vec2(-1e6f)});
    }
    std::stable_sort(reading.lines.begin(), reading.lines.end(), [](const auto& a, const auto& b) {
      return (std::isfinite(a.value) ? a.value : -INFINITY) > (std::isfinite(b.value) ? b.value : -INFINITY);
    });
    return reading;
  }
  return std::nullopt;
}

}  // namespace glint
