// The --report of `glint compare`: one HTML file that needs nothing beside it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/comparison_sheet.h"
#include "renderer/model_health.h"

namespace glint {

struct ReportNumbers {
  std::string row, column;
  double flip = 0, rmse = 0, largest = 0;
};

// The cells as embedded PNGs; a heat map is shown when the pointer is on the cell above it. `against` names the
// reference of the numbers. The cards are shown beneath, each unfolds, and the plots,
// which are SVG elements. Every other text from outside is escaped.
Result<std::string> comparisonReport(const std::string& title, std::span<const SheetRow>, const SheetText&,
                                     const std::string& against, std::span<const ReportNumbers>,
                                     std::span<const ModelHealth>, std::span<const std::string> plots,
                                     const std::map<std::string, std::string>& notes);

}  // namespace glint
