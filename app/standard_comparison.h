// The standard comparison: the thesis' models on its three materials under the studio. `glint` without a
// display makes it, so that a first run has something to show.
#pragma once

#include <filesystem>

#include "app/command.h"

namespace glint {

// Renders models blinn-phong, cook-torrance, burley, ggx on aluminium, rubber, black to `file`, as
// `glint compare` would, and prints the file's path on stdout. Returns the exit code; has reported its
// errors. The backend is chosen without a window.
int renderStandardComparison(const Arguments&, const std::filesystem::path& file = "comparison.png");

}  // namespace glint
