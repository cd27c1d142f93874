#include "app/comparison_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/text_painter.h"
#include "renderer/image_difference.h"
#include "renderer/image_io.h"
#include "renderer/reference_error.h"

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

// From the lowest to the highest error.
Image8 errorRamp(const Pixels<float>& ramp) {
  Image8 colors(ramp.width, ramp.height, 3);
  for (size_t i = 0; i < ramp.data.size(); ++i) {
    const glm::vec3 color = errorColor(2 * ramp.data[i] - 1);
    for (int k = 0; k < 3; ++k) colors.data[3 * i + size_t(k)] = uint8_t(std::lround(255 * srgbFromLinear(color[k])));
  }
  return colors;
}

constexpr int kMostLines = 3;  // of a title

// Lines of text beneath each other, each paragraph in its own style.
struct Block {
  struct Paragraph {
    std::vector<std::string> lines;
    TextStyle style;
  };
  std::vector<Paragraph> paragraphs;

  int height(TextPainter& painter) const {
    float sum = 0;
    for (const Paragraph& p : paragraphs) sum += float(p.lines.size()) * painter.lineHeight(p.style);
    return int(std::ceil(sum));
  }

  void draw(TextPainter& painter, Image8& sheet, float x, int top, TextAlign align) const {
    float y = float(top);
    for (const Paragraph& p : paragraphs)
      for (const std::string& line : p.lines) {
        painter.draw(sheet, x, y + painter.ascent(p.style), line, p.style, align);
        y += painter.lineHeight(p.style);
      }
  }
};

// The least width in which the text has at most so many lines with its words whole; `most` if it takes more.
float narrowest(TextPainter& painter, const std::string& text, const TextStyle& style, float most, int lines) {
  float low = 0, high = std::min(std::ceil(painter.width(text, style)), most);
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find_first_of(" *", at), text.size() - 1);
    low = std::max(low, painter.width(text.substr(at, end + 1 - at), style));
    at = end + 1;
  }
  low = std::ceil(std::min(low, high));
  const auto fits = [&](float width) { return int(painter.wrapped(text, style, width, lines + 1).size()) <= lines; };
  while (low < high && !fits(low)) low += std::max(1.0f, std::floor((high - low) / 16));
  return std::min(low, high);
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
  const Palette palette = paletteOn(text.ground.value_or(Color8{corner[0], corner[1], corner[2]}));

  // Everything in proportion to the cell, within what can be read and what does not shout.
  const float unit = std::clamp(float(cell) / 256, 0.5f, 2.0f);
  const auto px = [&](float at256) { return int(std::lround(at256 * unit)); };
  TextPainter painter;
  const auto style = [&](float at256, float least, TextFace face, Color8 color) { return TextStyle{std::max(at256 * unit, least), face, color}; };
  const TextStyle rowTitle = style(18, 13, TextFace::SemiBold, palette.title), columnTitle = style(17, 13, TextFace::SemiBold, palette.title);
  const TextStyle small = style(13.5f, 11.5f, TextFace::Regular, palette.dim), footer = style(12, 11, TextFace::Regular, palette.dim);
  const auto height = [&](const Block& block) { return block.height(painter); };
  const int margin = px(28), gap = std::max(px(10), 8), titleGap = px(22), lead = std::max(px(8), 5);

  // Columns are as wide as their cells, and wider where a number would not fit beneath a small one.
  const float widestColumn = std::max(float(cell), 9 * columnTitle.size);
  float columnWidth = float(cell);
  for (const std::string& title : text.columns) columnWidth = std::max(columnWidth, narrowest(painter, title, columnTitle, widestColumn, kMostLines));
  for (const SheetRow& row : rows)
    for (const std::string& line : row.captions) columnWidth = std::max(columnWidth, narrowest(painter, line, small, widestColumn, 2));
  columnWidth = std::max(columnWidth, (painter.width(text.axis, small) - float((columns - 1) * gap)) / float(columns));
  const int pitch = int(std::ceil(columnWidth));

  // Titles of rows: as narrow as lets each have few lines.
  float titlesWidth = 0;
  for (const SheetRow& row : rows) {
    const float least = std::max(float(cell) * 0.75f, 8 * rowTitle.size), most = 3 * least;
    for (const auto& [title, face] : {std::pair(row.title, row.heat ? small : rowTitle), std::pair(row.subtitle, small)})
      titlesWidth = std::max(titlesWidth, painter.width(title, face) <= least ? painter.width(title, face)
                                                                               : std::max(least, narrowest(painter, title, face, most, kMostLines)));
  }
  const int titles = int(std::ceil(titlesWidth));
  const int left = margin + (titles ? titles + titleGap : 0);
  const int cells = columns * pitch + (columns - 1) * gap;
  const std::string scale = text.heatWhite > 0    ? fmt::format("difference, up to {:.2g}", text.heatWhite)
                            : text.errorScale > 0 ? fmt::format("error, up to \u00b1{} %", std::lround(100 * text.errorScale)) : "";
  const int width = std::max(left + cells + margin, 2 * margin + int(std::ceil(painter.width(scale, footer))));

  // Everything is measured before anything is drawn.
  const Block axis{{{painter.wrapped(text.axis, small, float(cells), 2), small}}};
  std::vector<Block> heads;
  int headHeight = 0;
  for (const std::string& title : text.columns) {
    heads.push_back({{{painter.wrapped(title, columnTitle, float(pitch), kMostLines), columnTitle}}});
    headHeight = std::max(headHeight, height(heads.back()));
  }
  const int top = margin + (text.axis.empty() ? 0 : height(axis) + lead) + headHeight + lead;
  struct Strip {
    Block title;
    std::vector<Block> captions;
    int top = 0, picture = 0;  // the strip's, and that of its cells
  };
  std::vector<Strip> strips;
  int y = top;
  for (const SheetRow& row : rows) {
    Strip strip;
    strip.title = {{{painter.wrapped(row.title, row.heat ? small : rowTitle, float(titles), kMostLines), row.heat ? small : rowTitle},
                    {painter.wrapped(row.subtitle, small, float(titles), kMostLines), small}}};
    int captions = 0;
    for (const std::string& line : row.captions) {
      strip.captions.push_back({{{painter.wrapped(line, small, float(pitch), 2), small}}});
      captions = std::max(captions, height(strip.captions.back()));
    }
    const int tall = std::max(cell, height(strip.title));
    strip.top = y;
    strip.picture = y + (tall - cell) / 2;
    y += std::max(tall, (tall - cell) / 2 + cell + (captions ? lead / 2 + captions + lead : 0)) + gap;
    strips.push_back(std::move(strip));
  }

  // The scale stands right of the footer, or above it where both would not fit.
  const int bar = std::min(px(160), (width - 2 * margin) / 2), thick = std::max(px(8), int(footer.size * 0.8f));
  const int scaleWidth = scale.empty() ? 0 : std::max(bar + px(18), int(std::ceil(painter.width(scale, footer))));
  const int room = width - 2 * margin;
  const bool beside = painter.width(text.footer, footer) + float(scaleWidth + px(40)) <= float(room);
  const Block foot{{{painter.wrapped(text.footer, footer, float(room), kMostLines), footer}}};
  const int scaleHeight = scale.empty() ? 0 : int(std::ceil(painter.lineHeight(footer))) + thick + lead / 2;
  const int footHeight = beside ? std::max(height(foot), scaleHeight) : height(foot) + scaleHeight + lead;
  const int bottom = y + (footHeight ? lead : 0);
  Image8 sheet(width, bottom + footHeight + px(20), 3);
  for (size_t i = 0; i < sheet.data.size(); ++i) sheet.data[i] = palette.ground[i % 3];

  const auto center = [&](int column) { return float(left + column * (pitch + gap)) + float(pitch) / 2; };
  axis.draw(painter, sheet, float(left) + float(cells) / 2, margin, TextAlign::Center);
  for (int column = 0; column < columns; ++column)
    heads[size_t(column)].draw(painter, sheet, center(column), top - lead - height(heads[size_t(column)]), TextAlign::Center);
  for (size_t i = 0; i < rows.size(); ++i) {
    const Strip& strip = strips[i];
    strip.title.draw(painter, sheet, float(left - titleGap), strip.picture + (cell - height(strip.title)) / 2, TextAlign::Right);
    for (int column = 0; column < columns; ++column) {
      place(sheet, rows[i].cells[size_t(column)], left + column * (pitch + gap) + (pitch - cell) / 2, strip.picture);
      if (size_t(column) < strip.captions.size())
        strip.captions[size_t(column)].draw(painter, sheet, center(column), strip.picture + cell + lead / 2, TextAlign::Center);
    }
  }

  const int end = bottom + footHeight;
  if (!scale.empty()) {
    const int from = width - margin - bar, base = beside ? end : bottom + scaleHeight;
    Pixels<float> ramp(bar, thick, 1);
    for (size_t i = 0; i < ramp.data.size(); ++i) ramp.data[i] = float(int(i) % bar) / float(bar - 1);
    place(sheet, text.heatWhite > 0 ? heatMap(ramp) : errorRamp(ramp), from, base - thick);
    painter.draw(sheet, float(from - px(6)), float(base), text.heatWhite > 0 ? "0" : "\u2212", footer, TextAlign::Right);
    painter.draw(sheet, float(width - margin), float(base - thick - lead / 2 - 1), scale, footer, TextAlign::Right);
  }
  foot.draw(painter, sheet, float(margin), end - height(foot), TextAlign::Left);
  return sheet;
}

}  // namespace glint
