#include "materials/material_library.h"

#include <algorithm>

#include "materials/material_json.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr std::string_view kFolder = "materials/library";

}  // namespace

std::vector<std::string> libraryMaterialNames() {
  std::vector<std::string> names;
  for (const std::string& path : shipped::list(kFolder, ".json"))
    names.push_back(std::filesystem::path(path).stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<Material> loadMaterial(const std::string& nameOrPath, const NodeRegistry& registry, Diagnostics* warnings) {
  if (nameOrPath.empty()) return error("material", "has no name", suggestion("", libraryMaterialNames()));
  if (validNodeId(nameOrPath)) {
    const std::string path = fmt::format("{}/{}.json", kFolder, nameOrPath);
    if (const auto text = shipped::read(path)) {
      const std::filesystem::path file = shipped::onDisk(path);
      return parseMaterial(*text, file.empty() ? std::filesystem::path(path) : file, registry, warnings);
    }
    return error(fmt::format("material '{}'", nameOrPath), fmt::format("there is no '{}' in the library", nameOrPath),
                 suggestion(nameOrPath, libraryMaterialNames()));
  }
  return readMaterial(nameOrPath, registry, warnings);
}

}  // namespace glint
