// Paths that come from inside a file: they must stay in that file's folder (product.md 5).
#pragma once

#include <filesystem>
#include <string>

#include "materials/base/diagnostic.h"

namespace glint {

// `name` relative to `folder` (the working folder when empty), as an absolute path without links or dots. Errors:
// empty, absolute, or a path that leaves the folder, also through a link. The file need not exist.
Result<std::filesystem::path> resolveInside(const std::filesystem::path& folder, const std::string& name);

}  // namespace glint
