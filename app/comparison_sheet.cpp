#include "app/comparison_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/text_painter.h"
#include "renderer/image_difference.h"

namespace glint {
namespace {

using Color8 = std::array<uint8_t, 3>;

struct Palette {
  Color8 ground, title, dim;
};

// Text that is easy on the eye on this ground, light or dark.
Palette paletteOn(Color8 ground) {
  const int brightness = (ground[0] * 3 + ground[1] * 6 + ground[2]) / 10;
  if (brightness > 128) return {ground, {24, 25, 28}, {96, 98, 104}};
  return {ground, {236, 237, 240}, {150, 153, 161}};
}

void place(Image8& sheet, const Image8& cell, int left, int top) {
  for (int y = 0; y < cell.height; ++y)
    for (int x = 0; x < cell.width; ++x)
      for (int k = 0; k < 3; ++k) sheet.at(left + x, top + y)[k] = cell.at(x, y)[cell.channels < 3 ? 0 : k];
}

}  // namespace

Image8 cutCell(const Image8& picture, const glm::ivec4& rectangle) {
  Image8 cell(rectangle.z, rectangle.w, picture.channels);
  const int top = picture.height - rectangle.y - rectangle.w;
  for (int y = 0; y < cell.height; ++y)
    std::memcpy(cell.at(0, y), picture.at(rectangle.x, top + y), size_t(cell.width) * size_t(cell.channels));
  return cell;
}

Image8 comparisonSheet(std::span<const SheetRow> rows, const SheetText& text) {
  GLINT_CHECK(!rows.empty() && !rows[0].cells.empty());
  const int cell = rows[0].cells[0].width, columns = int(rows[0].cells.size());
  const uint8_t* corner = rows[0].cells[0].at(0, 0);
  const Palette palette = paletteOn({corner[0], corner[1], corner[2]});

  // Everything in proportion to the cell, within what can be read and what does not shout.
  const float unit = std::clamp(float(cell) / 256, 0.5f, 2.0f);
  const auto px = [&](float at256) { return int(std::lround(at256 * unit)); };
  TextPainter painter;
  const TextStyle rowTitle{18 * unit, TextFace::SemiBold, palette.title}, rowSubtitle{13.5f * unit, TextFace::Regular, palette.dim};
  const TextStyle columnTitle{17 * unit, TextFace::SemiBold, palette.title}, axisTitle{13.5f * unit, TextFace::Regular, palette.dim};
  const TextStyle caption{13 * unit, TextFace::Regular, palette.dim}, footer{12 * unit, TextFace::Regular, palette.dim};

  float widest = 0;
  bool captions = false;
  for (const SheetRow& row : rows) {
    widest = std::max({widest, painter.width(row.title, rowTitle), painter.width(row.subtitle, rowSubtitle)});
    captions |= std::any_of(row.captions.begin(), row.captions.end(), [](const auto& c) { return !c.empty(); });
  }
  const int margin = px(28), gap = px(10), titleGap = px(22);
  const int titles = std::min(int(std::ceil(widest)), std::max(cell * 3 / 4, px(150)));
  const int left = margin + (titles ? titles + titleGap : 0);
  const int top = margin + (text.axis.empty() ? 0 : px(22)) + px(34);
  const int captionHeight = captions ? px(24) : 0;
  const int bottom = (text.footer.empty() ? px(20) : px(52));
  const int rowHeight = cell + captionHeight + gap;
  const int width = left + columns * cell + (columns - 1) * gap + margin;
  const int height = top + int(rows.size()) * rowHeight - gap + bottom;
  Image8 sheet(width, height, 3);
  for (size_t i = 0; i < sheet.data.size(); ++i) sheet.data[i] = palette.ground[i % 3];

  const auto columnLeft = [&](int column) { return left + column * (cell + gap); };
  const float cells = float(columnLeft(columns) - gap - left);
  if (!text.axis.empty())
    painter.draw(sheet, float(left) + cells / 2, float(margin + px(14)), painter.fitted(text.axis, axisTitle, cells), axisTitle, TextAlign::Center);
  for (int column = 0; column < columns; ++column)
    painter.draw(sheet, float(columnLeft(column)) + float(cell) / 2, float(top - px(14)),
                 painter.fitted(text.columns[size_t(column)], columnTitle, float(cell)), columnTitle, TextAlign::Center);
  for (size_t i = 0; i < rows.size(); ++i) {
    const SheetRow& row = rows[i];
    const int y = top + int(i) * rowHeight;
    const float middle = float(y) + float(cell) / 2, right = float(left - titleGap);
    const bool two = !row.subtitle.empty();
    painter.draw(sheet, right, middle + 6 * unit - (two ? 9 * unit : 0), painter.fitted(row.title, row.heat ? rowSubtitle : rowTitle, float(titles)),
                 row.heat ? rowSubtitle : rowTitle, TextAlign::Right);
    if (two)
      painter.draw(sheet, right, middle + 17 * unit, painter.fitted(row.subtitle, rowSubtitle, float(titles)), rowSubtitle, TextAlign::Right);
    for (int column = 0; column < columns; ++column) {
      place(sheet, row.cells[size_t(column)], columnLeft(column), y);
      if (size_t(column) < row.captions.size())
        painter.draw(sheet, float(columnLeft(column)) + float(cell) / 2, float(y + cell + px(17)),
                     painter.fitted(row.captions[size_t(column)], caption, float(cell)), caption, TextAlign::Center);
    }
  }

  const int base = height - px(20);
  int footerWidth = width - 2 * margin;
  if (text.heatWhite > 0) {
    const int bar = std::min(px(160), footerWidth / 3), thick = px(8), from = width - margin - bar;
    Pixels<float> ramp(bar, thick, 1);
    for (size_t i = 0; i < ramp.data.size(); ++i) ramp.data[i] = float(int(i) % bar) / float(bar - 1);
    place(sheet, heatMap(ramp), from, base - thick);
    const std::string most = fmt::format("{:.2g}", text.heatWhite);
    painter.draw(sheet, float(from - px(6)), float(base), "0", footer, TextAlign::Right);
    painter.draw(sheet, float(width - margin), float(base - thick - px(6)), "difference, up to " + most, footer, TextAlign::Right);
    footerWidth -= bar + px(40);
  }
  painter.draw(sheet, float(margin), float(base), painter.fitted(text.footer, footer, float(footerWidth)), footer);
  return sheet;
}

}  // namespace glint
