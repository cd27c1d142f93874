// glint compare --plot: curves and slices of models instead of spheres.
#pragma once

#include "app/command.h"
#include "app/scene_options.h"

namespace glint {

// The whole command when --plot is given; `models` is what --models says, each once. Returns the exit code; has reported
// its errors.
int plotComparison(const Arguments&, const Result<std::vector<ModelChoice>>& models);

}  // namespace glint
