// The picture of a comparison: its cells with titles, and with difference heat maps where they are wanted.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/comparison.h"
#include "renderer/image.h"

namespace glint {

// One strip of cells on a sheet, all of one size.
struct SheetRow {
  std::string title, subtitle;          // left of the row; the subtitle small and dim beneath
  std::vector<Image8> cells;
  std::vector<std::string> captions;    // beneath each cell; empty: none
  bool heat = false;                    // a heat map that belongs to the row above
};

struct SheetText {
  std::string axis;                     // above the column titles: what a sweep changes
  std::vector<std::string> columns;
  std::string footer;                   // how it was lit, at the bottom
  float heatWhite = 0;                  // above 0: a scale for the heat maps, up to this value
  std::optional<std::array<uint8_t, 3>> ground;   // empty: the colour of the first cell's corner
  float errorScale = 0;                 // above 0: a scale for the error view (RenderSettings)
};

// Lays them out in Inter on the ground that the cells stand on, so that a plain
// background runs through the whole sheet. Sizes follow the cell's down to what can be read: columns grow wider than small cells
// for the sake of their titles and captions, and long titles go on in up to three lines.
Image8 comparisonSheet(std::span<const SheetRow>, const SheetText&);

// One cell cut out of a picture of the whole grid, by its rectangle from the bottom left.
Image8 cutCell(const Image8& picture, const glm::ivec4& rectangle);

}  // namespace glint
