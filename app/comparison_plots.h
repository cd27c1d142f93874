// The plots of a comparison's models, for its report. Needs a current context.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/comparison.h"

namespace glint {

// SVG elements for a page: D, V and F of models that have them, lobes with a cosine, and directional albedos, each model
// once with its row's parameters. Errors: of models that do not compile.
Result<std::vector<std::string>> comparisonPlots(std::span<const ComparisonRow>);

}  // namespace glint
