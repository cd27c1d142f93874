// Titles and legends of plots, and the colours that curves have.
#include <algorithm>
#include <set>

#include "app/analysis/plot_layout_parts.h"

namespace glint::plot_layout {

Sheet::Sheet(const PlotData& d, const PlotView& v, const TextMeasure& m) : data(d), view(v), measure(m), unit(v.unit) {
  const bool dark = data.settings.ground == PlotGround::Dark;
  const auto grey = [](uint8_t level) { return PlotColor{level, level, level, 255}; };
  drawing.size = view.size;
  drawing.ground = view.ground.value_or(dark ? grey(24) : grey(255));
  ink = dark ? grey(222) : grey(24);
  dim = dark ? grey(150) : grey(92);
  axis = dark ? grey(112) : grey(120);
  grid = dark ? grey(50) : grey(222);
  faint = dark ? grey(37) : grey(240);

  std::set<size_t> drawn;
  for (const PlotCurve& curve : data.curves) drawn.insert(curve.subject);
  const std::vector<PlotColor> own = distinctColors(data.colors, dark);
  dashed = drawn.size() > 1 || data.variants.size() < 2;
  std::vector<PlotColor> ramp;
  if (!dashed) {
    ramp = colorRamp(data.colors[*drawn.begin()], data.variants.size(), dark);
    if (data.variants.size() == 3 && data.settings.channel == PlotChannel::Rgb && data.variants[0] == "r")
      ramp = dark ? std::vector<PlotColor>{{236, 110, 100}, {120, 200, 110}, {110, 160, 245}} : std::vector<PlotColor>{{204, 40, 40}, {30, 140, 50}, {40, 80, 210}};
  }
  for (const PlotCurve& curve : data.curves) drawing.colors.push_back(dashed ? own[curve.subject] : ramp[curve.variant]);
}

void Sheet::line(std::vector<glm::vec2> points, float width, PlotColor color, std::vector<float> dash) {
  drawing.items.push_back(PlotLine{std::move(points), width > 1 ? width * unit : 1, color, std::move(dash)});
}

void Sheet::text(glm::vec2 at, float size, bool bold, PlotColor color, TextAlign align, const std::string& words) {
  if (!words.empty()) drawing.items.push_back(PlotText{{std::round(at.x), std::round(at.y)}, std::round(size * unit), bold, color, align, words});
}

void Sheet::bitmap(glm::vec2 low, glm::vec2 high, Image8 pixels) {
  PlotBitmap& added = std::get<PlotBitmap>(drawing.items.emplace_back(std::in_place_type<PlotBitmap>));
  added.low = low;
  added.high = high;
  added.pixels = std::move(pixels);
}

std::string Sheet::fitted(const std::string& words, float size, bool bold, float room) const {
  if (width(words, size, bold) <= room) return words;
  std::string kept = words;
  while (!kept.empty()) {
    while (kept.size() > 1 && (static_cast<unsigned char>(kept.back()) & 0xc0) == 0x80) kept.pop_back();
    kept.pop_back();
    if (width(kept + "\u2026", size, bold) <= room) break;
  }
  return kept + "\u2026";
}

float Sheet::drawHead() {
  float y = px(12);
  const float room = static_cast<float>(view.size.x) - 2 * margin();
  if (view.title) {
    y += px(18);
    text({margin(), y}, 17, true, ink, TextAlign::Left, fitted(plotTitle(data.settings), 17, true, room));
    if (const std::string conditions = plotConditions(data); !conditions.empty()) {
      y += px(19);
      text({margin(), y}, 12, false, dim, TextAlign::Left, fitted(conditions, 12, false, room));
    }
    y += px(9);
  }
  y = drawLegend(y);
  for (const std::string& note : data.notes) {
    y += px(17);
    text({margin(), y}, 12, false, dim, TextAlign::Left, fitted(note, 12, false, room));
  }
  return y + px(6);
}

float Sheet::drawLegend(float y) {
  const float sample = px(26), gap = px(8), between = px(22), line = px(21), right = static_cast<float>(view.size.x) - margin();
  const bool slices = data.settings.kind == PlotKind::Slice;
  struct Entry {
    std::string title;
    PlotColor color;
    std::vector<float> dash;
    int subject = -1;
  };
  std::vector<std::vector<Entry>> groups(2);
  for (size_t i = 0; !slices && i < data.titles.size(); ++i) {
    Entry entry{data.titles[i], dim, {}, static_cast<int>(i)};
    bool drawn = false;
    for (size_t k = 0; k < data.curves.size() && !drawn; ++k)
      if (data.curves[k].subject == i) {
        drawn = true;
        entry.color = drawing.colors[k];
      }
    if (drawn && (dashed || data.titles.size() > 1)) groups[0].push_back(entry);
    else if (drawn) groups[0].push_back({data.titles[i], PlotColor{0, 0, 0, 0}, {}, static_cast<int>(i)});
  }
  if (!slices && data.variants.size() > 1)
    for (size_t v = 0; v < data.variants.size(); ++v) {
      Entry entry{data.variants[v], dim, dashOf(v, unit), -1};
      if (!dashed) {
        entry.dash.clear();
        for (size_t k = 0; k < data.curves.size(); ++k)
          if (data.curves[k].variant == v) entry.color = drawing.colors[k];
      }
      groups[1].push_back(entry);
    }
  for (const auto& group : groups) {
    if (group.empty()) continue;
    float x = margin();
    y += line;
    for (const Entry& entry : group) {
      const bool plain = entry.color.a == 0;   // the title of the one model, whose variants have the colours
      const bool hidden = entry.subject >= 0 && view.hidden.count(static_cast<size_t>(entry.subject));
      const std::string title = fitted(entry.title, 14, plain, right - margin() - sample - gap);
      const float wide = (plain ? 0 : sample + gap) + width(title, 14, plain);
      if (x > margin() && x + wide > right) {
        x = margin();
        y += line;
      }
      if (entry.subject >= 0) drawing.legend.push_back({static_cast<size_t>(entry.subject), {x - px(4), y - px(15)}, {x + wide + px(6), y + px(6)}});
      if (!plain) this->line({{x, y - px(4.5f)}, {x + sample, y - px(4.5f)}}, 2, hidden ? grid : entry.color, entry.dash);
      text({x + (plain ? 0 : sample + gap), y}, 14, plain, hidden ? axis : ink, TextAlign::Left, title);
      x += wide + between;
    }
  }
  return y;
}

}  // namespace glint::plot_layout
