// The materials that Glint ships (materials/library/), and finding one by name or path.
#pragma once

#include <string>
#include <vector>

#include "materials/graph.h"
#include "materials/node_registry.h"

namespace glint {

std::vector<std::string> libraryMaterialNames();  // sorted

// A library name ("aluminium") or a path to a .json file; a file of that name in the working folder is meant
// only when it is written with its extension. An unknown name is an error that names the nearest.
Result<Material> loadMaterial(const std::string& nameOrPath, const NodeRegistry&,
                              Diagnostics* warnings = nullptr);

}  // namespace glint
