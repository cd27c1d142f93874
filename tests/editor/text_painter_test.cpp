#include "app/text_painter.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

int inked(const Image8& picture, int x0, int x1) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = x0; x < x1; ++x) count += picture.at(x, y)[0] > 128;
  return count;
}

TEST(TextPainter, DrawsWhereAndAsWideAsItSays) {
  TextPainter painter;
  Image8 picture(200, 40, 3);
  const TextStyle style{.size = 20, .color = {255, 255, 255}};
  const float width = painter.width("roughness", style);
  EXPECT_GT(width, 60);
  EXPECT_LT(width, 120);
  painter.draw(picture, 100, 28, "roughness", style, TextAlign::Center);
  EXPECT_GT(inked(picture, 0, 200), 200);
  EXPECT_EQ(inked(picture, 0, static_cast<int>(100 - width / 2) - 1), 0);
  EXPECT_EQ(inked(picture, static_cast<int>(100 + width / 2) + 2, 200), 0);
}

TEST(TextPainter, CutsAtThePictureAndTakesAnyBytes) {
  TextPainter painter;
  Image8 picture(16, 16, 4);
  painter.draw(picture, -40, 3, "far out \xff\xc3 \xf0\x9f\x98\x80", {.size = 40});
  painter.draw(picture, 10, 12, "\xe2\x82", {});
  EXPECT_EQ(picture.width, 16);
}

TEST(TextPainter, ShortensWithAnEllipsis) {
  TextPainter painter;
  const TextStyle style{.size = 16};
  const std::string name = "brushed-aluminium-é";
  EXPECT_EQ(painter.fitted(name, style, 500), name);
  const std::string cut = painter.fitted(name, style, 80);
  EXPECT_LE(painter.width(cut, style), 80);
  EXPECT_EQ(cut.substr(0, 4), "brus");
  EXPECT_EQ(cut.substr(cut.size() - 3), "\u2026");
}

TEST(TextPainter, WrapsWhereAReaderWouldBreak) {
  TextPainter painter;
  const TextStyle style{.size = 16};
  using Lines = std::vector<std::string>;
  EXPECT_EQ(painter.wrapped("", style, 100, 3), Lines{});
  EXPECT_EQ(painter.wrapped("roughness", style, 100, 3), Lines{"roughness"});
  EXPECT_EQ(painter.wrapped("GGX*Smith*Schlick", style, 80, 3), (Lines{"GGX*", "Smith*", "Schlick"}));
  EXPECT_EQ(painter.wrapped("one two", style, 40, 3), (Lines{"one", "two"}));
  for (const std::string& line : painter.wrapped(std::string(300, 'w'), style, 60, 3)) EXPECT_LE(painter.width(line, style), 60);
  EXPECT_EQ(painter.wrapped(std::string(300, 'w'), style, 60, 3).size(), 3u);
  EXPECT_EQ(painter.wrapped("\u00e9\u00e9", style, 1, 9), (Lines{"\u00e9", "\u00e9"}));  // never within a code point
}

}  // namespace
}  // namespace glint
