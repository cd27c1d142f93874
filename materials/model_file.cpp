#include "materials/model_file.h"

#include <algorithm>

#include "materials/base/files.h"
#include "materials/brdf_file.h"

namespace glint {

const std::vector<std::string>& modelFileExtensions() {
  static const std::vector<std::string> extensions = {".glsl", ".brdf", ".bparam"};
  return extensions;
}

bool isModelFile(const std::filesystem::path& path) {
  const auto& all = modelFileExtensions();
  return std::find(all.begin(), all.end(), path.extension().string()) != all.end();
}

Result<ShadingModel> readModel(const std::filesystem::path& path, const std::string& text, Diagnostics& warnings) {
  if (path.extension() == ".brdf") return parseBrdf(path, text, warnings);
  if (path.extension() == ".bparam") return parseBparam(path, text, warnings);
  return parseModel(path, text);
}

Result<ShadingModel> readModelFile(const std::filesystem::path& path, Diagnostics& warnings) {
  const auto text = readFile(path, kLargestModelFile);
  if (!text) return text.diagnostics();
  return readModel(path, *text, warnings);
}

std::filesystem::path fileBehind(const std::filesystem::path& path, const std::string& text) {
  if (path.extension() != ".bparam") return {};
  const auto found = fileOfBparam(path, text);
  return found ? *found : std::filesystem::path();
}

}  // namespace glint
