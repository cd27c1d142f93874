// The image slices of several models side by side, with the scale to read them by.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/analysis/plot_layout_parts.h"
#include "renderer/image_difference.h"
#include "renderer/image_io.h"

namespace glint::plot_layout {
namespace {

// The scale of the values: between those that nearly all are above and below; peaks are sharper than any scale can show.
PlotAxis scaleOf(const PlotData& data) {
  const PlotSettings& s = data.settings;
  std::vector<double> values;
  for (const PlotSlice& slice : data.slices)
    for (size_t i = 0; i < slice.f.data.size(); i += 3) {
      const glm::dvec3 f(slice.f.data[i], slice.f.data[i + 1], slice.f.data[i + 2]);
      const double value = s.channel == PlotChannel::Rgb ? std::max({f.r, f.g, f.b}) : channelValue(f, s.channel);
      if (std::isfinite(value) && value > 0) values.push_back(value);
    }
  if (values.empty()) return {s.log ? 1e-4 : 0, 1, s.log ? PlotScale::Log : PlotScale::Linear};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double part) { return values[std::min(values.size() - 1, static_cast<size_t>(part * static_cast<double>(values.size())))]; };
  if (s.log) {
    PlotAxis axis = roundAxis(quantile(0.05), s.most ? static_cast<double>(*s.most) : quantile(0.995), PlotScale::Log);
    if (s.most) axis.high = *s.most;
    return axis;
  }
  if (s.most) return {0, *s.most, PlotScale::Linear};
  return roundAxis(0, quantile(0.97), PlotScale::Linear);
}

Image8 picture(const PlotSlice& slice, const PlotAxis& scale, const PlotSettings& s) {
  const auto unit = [&](double value) { return std::isfinite(value) ? static_cast<float>(std::clamp(scale.unit(value), 0.0, 1.0)) : 0.0f; };
  if (s.channel == PlotChannel::Rgb) {
    Image8 image(slice.f.width, slice.f.height, 3);
    for (size_t i = 0; i < image.data.size(); ++i) {
      const float u = unit(slice.f.data[i]);
      image.data[i] = static_cast<uint8_t>(std::lround(255 * (s.log ? u : srgbFromLinear(u))));
    }
    return image;
  }
  Pixels<float> map(slice.f.width, slice.f.height, 1);
  for (size_t i = 0; i < map.data.size(); ++i) map.data[i] = unit(channelValue({slice.f.data[3 * i], slice.f.data[3 * i + 1], slice.f.data[3 * i + 2]}, s.channel));
  return heatMap(map);
}

// Bottom to top as the values.
Image8 ramp(int height, const PlotAxis& scale, const PlotSettings& s) {
  PlotSlice slice{0, ImageF(1, height, 3)};
  for (int y = 0; y < height; ++y)
    for (int k = 0; k < 3; ++k) slice.f.at(0, y)[k] = static_cast<float>(scale.value(1 - (y + 0.5) / height));
  return picture(slice, scale, s);
}

}  // namespace

void drawSlices(Sheet& sheet, float top) {
  const PlotData& data = sheet.data;
  std::vector<size_t> shown;
  for (size_t i = 0; i < data.slices.size(); ++i) shown.push_back(i);
  if (shown.empty()) return;
  const PlotAxis scale = scaleOf(data), angle{0, 90, PlotScale::Degrees};
  const int height = static_cast<int>(shown.size());
  const float left = sheet.margin() + sheet.px(34), scaleRoom = std::max(sheet.px(78), sheet.width(yTitle(data.settings), 12) + sheet.px(24)), bottom = static_cast<float>(sheet.view.size.y) - sheet.px(30);
  const float right = static_cast<float>(sheet.view.size.x) - sheet.margin() - scaleRoom;
  const float gapX = sheet.px(20), gapY = sheet.px(46), head = sheet.px(42);
  // As many columns as make the pictures largest.
  float side = 0;
  int columns = 1;
  for (int c = 1; c <= height; ++c) {
    const int rows = (height + c - 1) / c;
    const float fits = std::min((right - left - gapX * static_cast<float>(c - 1)) / static_cast<float>(c),
                                (bottom - top - head - sheet.px(14) - gapY * static_cast<float>(rows - 1)) / static_cast<float>(rows));
    if (fits <= side) continue;
    side = fits;
    columns = c;
  }
  side = std::floor(side);
  if (side < 16) return;
  const int rows = (height + columns - 1) / columns;
  const auto ticks = angle.ticks(side > sheet.px(110) ? 3 : 2);
  sheet.text({sheet.margin(), top + sheet.px(14)}, 12, false, sheet.ink, TextAlign::Left, "\u03b8_{d}, light from the half vector");
  for (int n = 0; n < height; ++n) {
    const PlotSlice& slice = data.slices[shown[static_cast<size_t>(n)]];
    const int row = n / columns, column = n % columns;
    PlotFrame frame{PlotFrame::Slice, {}, {}, angle, angle, shown[static_cast<size_t>(n)]};
    frame.low = {std::round(left + static_cast<float>(column) * (side + gapX)), std::round(top + head + static_cast<float>(row) * (side + gapY))};
    frame.high = frame.low + side;
    sheet.bitmap(frame.low, frame.high, picture(slice, scale, data.settings));
    sheet.text({frame.low.x, frame.low.y - sheet.px(8)}, 14, false, sheet.ink, TextAlign::Left, sheet.fitted(data.titles[slice.subject], 14, false, side));
    for (const PlotTick& tick : ticks) {
      const glm::vec2 x = frame.place(tick.value, 0), y = frame.place(0, tick.value);
      // The last label under one picture would run into the first under the next.
      const TextAlign align = tick.value == 0 ? TextAlign::Left : tick.value == 90 ? TextAlign::Right : TextAlign::Center;
      sheet.line({{x.x, frame.high.y}, {x.x, frame.high.y + sheet.px(4)}}, 1, sheet.axis);
      sheet.text({x.x, frame.high.y + sheet.px(17)}, 12, false, sheet.dim, align, tick.label);
      if (column > 0) continue;
      sheet.line({{frame.low.x - sheet.px(4), y.y}, {frame.low.x, y.y}}, 1, sheet.axis);
      sheet.text({frame.low.x - sheet.px(7), y.y + sheet.px(4)}, 12, false, sheet.dim, TextAlign::Right, tick.label);
    }
    sheet.drawing.frames.push_back(frame);
  }
  const PlotFrame &first = sheet.drawing.frames.front(), &last = sheet.drawing.frames[static_cast<size_t>((rows - 1) * columns)];
  const float end = first.low.x + static_cast<float>(columns) * (side + gapX) - gapX;
  sheet.text({0.5f * (first.low.x + end), last.high.y + sheet.px(35)}, 12, false, sheet.ink, TextAlign::Center, xTitle(data.settings));
  // The scale.
  const glm::vec2 low{end + sheet.px(22), first.low.y}, high{low.x + sheet.px(14), std::min(last.high.y, first.low.y + sheet.px(360))};
  sheet.bitmap(low, high, ramp(static_cast<int>(high.y - low.y), scale, data.settings));
  for (const PlotTick& tick : scale.ticks(std::max(2, static_cast<int>((high.y - low.y) / sheet.px(44))))) {
    const float y = std::round(high.y - static_cast<float>(scale.unit(tick.value)) * (high.y - low.y));
    if (tick.label.empty()) continue;
    sheet.line({{high.x, y}, {high.x + sheet.px(4), y}}, 1, sheet.axis);
    sheet.text({high.x + sheet.px(7), y + sheet.px(4)}, 12, false, sheet.dim, TextAlign::Left, tick.label);
  }
  sheet.text({low.x, top + sheet.px(14)}, 12, false, sheet.ink, TextAlign::Left, yTitle(data.settings));
}

}  // namespace glint::plot_layout
