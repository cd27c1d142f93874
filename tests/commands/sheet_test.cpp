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

TEST(Report, IsOneFileAndEscapesWhatItIsTold) {
  const std::vector<SheetRow> rows = {{"<script>", "", {plain(8, 28)}, {}, false}};
  const auto html = comparisonReport("<title> & \"more\"", rows, {"", {"a&b"}, "", 0}, "ggx", std::vector<ReportNumbers>{{"r", "c", 0.5, 0.25, 1}}, {{"Command", "glint '<x>'"}});
  ASSERT_TRUE(html);
  EXPECT_EQ(html->find("<script"), std::string::npos);
  EXPECT_NE(html->find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(html->find("a&amp;b"), std::string::npos);
  EXPECT_EQ(html->find("http"), std::string::npos);
}

}  // namespace
}  // namespace glint
