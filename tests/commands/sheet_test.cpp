// The layout of a comparison's picture.
#include <gtest/gtest.h>

#include "app/comparison_report.h"
#include "app/comparison_sheet.h"

namespace glint {
namespace {

Image8 plain(int side, uint8_t value) {
  Image8 image(side, side, 3);
  std::fill(image.data.begin(), image.data.end(), value);
  image.at(side / 2, side / 2)[0] = 255;
  return image;
}

bool found(const Image8& sheet, const Image8& cell) {
  for (int y = 0; y + cell.height <= sheet.height; ++y)
    for (int x = 0; x + cell.width <= sheet.width; ++x) {
      bool same = true;
      for (int r = 0; r < cell.height && same; ++r)
        same = std::equal(cell.at(0, r), cell.at(0, r) + 3 * cell.width, sheet.at(x, y + r));
      if (same) return true;
    }
  return false;
}

TEST(Sheet, HoldsItsCellsUnchangedOnTheirGround) {
  const std::vector<SheetRow> rows = {{"A model with a very long title that will not fit", "gamma 2", {plain(32, 28), plain(32, 29)}, {}, false},
                                      {"", "", {plain(32, 60), Image8()}, {"FLIP 0.1", ""}, true}};
  const Image8 sheet = comparisonSheet(rows, {"roughness", {"0", "a long title of a column"}, "studio", 0.5f});
  EXPECT_EQ(sheet.at(0, 0)[0], 28);
  EXPECT_TRUE(found(sheet, rows[0].cells[0]));
  EXPECT_TRUE(found(sheet, rows[0].cells[1]));
  EXPECT_TRUE(found(sheet, rows[1].cells[0]));
}

// The last character of each text shows in the picture: none ends in dots or lies outside, however small the cells.
TEST(Sheet, CutsNoTextAtAnySizeOfCell) {
  for (const int cell : {32, 64, 100, 256, 512})
    for (const size_t columns : {1u, 3u}) {
      const auto sheet = [&](int changed) {
        const auto end = [&](int which) { return which == changed ? "8" : "1"; };
        const std::vector<Image8> cells(columns, plain(cell, 28));
        const std::vector<SheetRow> rows = {
            {std::string("GGX x SmithGGXCorrelated x Schlick x Lambert") + end(1), std::string("gamma 1.5, roughness 0.") + end(2), cells, {}, false},
            {std::string("against ggx") + end(3), "", cells, std::vector<std::string>(columns, std::string("FLIP\u00a00.102   RMSE\u00a00.04") + end(4)), true}};
        return comparisonSheet(rows, {std::string("roughness") + end(5), std::vector<std::string>(columns, std::string("painted-metal 0.2") + end(6)),
                                      std::string("environment studio, 2 lights, exposure ") + end(7), 0.5f});
      };
      const Image8 first = sheet(0);
      for (int changed = 1; changed <= 7; ++changed) {
        const Image8 other = sheet(changed);
        EXPECT_TRUE(other.width != first.width || other.data != first.data) << "cell " << cell << ", text " << changed;
      }
      for (int y = 0; y < first.height; ++y) {
        EXPECT_EQ(first.at(1, y)[0], 28);
        EXPECT_EQ(first.at(first.width - 2, y)[0], 28);
      }
    }
}

TEST(Report, IsOneFileAndEscapesWhatItIsTold) {
  const std::vector<SheetRow> rows = {{"<script>", "", {plain(8, 28)}, {}, false}};
  const auto html = comparisonReport("<title> & \"more\"", rows, {"", {"a&b"}, "", 0}, "ggx", std::vector<ReportNumbers>{{"r", "c", 0.5, 0.25, 1}}, {}, std::vector<std::string>{"<svg></svg>"}, {{"Command", "glint '<x>'"}});
  ASSERT_TRUE(html);
  EXPECT_EQ(html->find("<script"), std::string::npos);
  EXPECT_NE(html->find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(html->find("a&amp;b"), std::string::npos);
  EXPECT_NE(html->find("<svg></svg>"), std::string::npos);
  EXPECT_EQ(html->find("http"), std::string::npos);
}

}  // namespace
}  // namespace glint
