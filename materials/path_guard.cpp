#include "materials/path_guard.h"

#include <algorithm>

namespace glint {

Result<std::filesystem::path> resolveInside(const std::filesystem::path& folder, const std::string& name) {
  const std::string place = fmt::format("'{}'", name.substr(0, 200));
  if (name.empty()) return error("file", "has no name", "name a file");
  if (name.size() > 4096 || name.find('\0') != name.npos) return error(place, "is no path", "name a file below the folder");
  const std::filesystem::path relative(name);
  if (relative.is_absolute())
    return error(place, "is an absolute path", "give it relative to the folder of the material");
  std::error_code failed;
  const std::filesystem::path root =
      std::filesystem::weakly_canonical(folder.empty() ? std::filesystem::current_path(failed) : folder, failed);
  if (failed) return error(folder.string(), "cannot be resolved: " + failed.message(), "check the path");
  const std::filesystem::path full = std::filesystem::weakly_canonical(root / relative, failed);
  if (failed) return error(place, "cannot be resolved: " + failed.message(), "check the path");
  const auto [rootEnd, fullEnd] = std::mismatch(root.begin(), root.end(), full.begin(), full.end());
  if (rootEnd != root.end() && !rootEnd->empty())
    return error(place, "leaves the folder of the material", "copy the file beside the material");
  return full;
}

}  // namespace glint
