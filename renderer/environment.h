// Environments: read from .hdr and .exr files, or made by Glint.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/scene.h"

namespace glint {

// "studio": softboxes on a dark ground, the default; "sky": a clear sky with a sun; "furnace": 1 everywhere.
std::vector<std::string> environmentNames();  // also "none"
// One of the names, "none" (gives a null pointer), or a file. Errors: unreadable; not 2:1; NaN, infinite or
// negative pixels (named with the place of the first); a side over kLargestImageSide.
Result<EnvironmentPtr> loadEnvironment(const std::string& nameOrFile);

}  // namespace glint
