// The gate before tinygltf: it crashes on hostile files, so nothing reaches it that this has not gone over.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "materials/base/diagnostic.h"

namespace glint {

// A file that may be given to tinygltf.
struct CheckedGltf {
  bool binary = false;
  // The files that it names, by the names that tinygltf will ask for, each resolved and inside the model's folder.
  std::map<std::string, std::filesystem::path> files;
};

// Goes over the container and the JSON: nesting, sizes, every index and byte range, component types, node
// hierarchy, required extensions, the files that are named. Every fault is reported (up to a dozen or so), as
// "FILE: accessors[3].bufferView is 9 ..." with the line in front for .gltf. Warnings: what is not read.
Result<CheckedGltf> checkGltf(std::string_view bytes, const std::filesystem::path& file, Diagnostics& warnings);

// The file that a URI of a model names. Errors: anything but a relative path, one that leaves `folder` (also by
// way of a symbolic link), no such file.
Result<std::filesystem::path> resolveGltfUri(const std::string& uri, const std::filesystem::path& folder,
                                             const std::string& place);

}  // namespace glint
