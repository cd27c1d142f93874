#include "app/editor/scene_store.h"

#include <algorithm>
#include <vector>

#include "materials/base/files.h"
#include "materials/base/hash.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kLargest = uint64_t{1} << 20;
constexpr size_t kMost = 256;

}  // namespace

fs::path SceneStore::fileOf(const fs::path& material) const {
  return folder_ / (hashName(hashText(material.string())) + ".json");
}

std::optional<Preview> SceneStore::read(const fs::path& material, Diagnostics& warnings) const {
  if (folder_.empty()) return std::nullopt;
  const fs::path file = fileOf(material);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  const auto leftAside = [&](const std::string& why) {
    warnings.push_back(warning(file.string(), "the scene kept for " + material.filename().string() + " is damaged and was left aside (" + why + ")",
                               "set the scene up anew: it is kept again from then on"));
    return std::nullopt;
  };
  const auto bytes = readFile(file, kLargest);
  if (!bytes) return leftAside(bytes.diagnostics().front().what);
  const auto json = parseJson(bytes.value(), file.string());
  if (!json) return leftAside(json.diagnostics().front().what);
  const Json *owner = json->find("material"), *scene = json->find("scene");
  if (!owner || !owner->isString() || !scene || !scene->isObject()) return leftAside("it names no material or has no scene");
  if (owner->text != material.string()) return std::nullopt;  // another file of the same hash
  Diagnostics faults;
  Preview preview = previewFrom(*scene, file.string(), faults);
  if (!faults.empty()) return leftAside(faults.front().what);
  return preview;
}

Diagnostics SceneStore::write(const fs::path& material, const Preview& preview) const {
  if (folder_.empty()) return {};
  Json json = Json::object();
  json.set("glint", Json::of("scene"));
  json.set("version", Json::of(1));
  json.set("material", Json::of(material.string()));
  json.set("scene", previewJson(preview));
  const fs::path file = fileOf(material);
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  const bool added = !fs::exists(file, ignored);
  Diagnostics problems = writeFileAtomic(file, writeJson(json));
  if (added) forgetOldest();
  return problems;
}

void SceneStore::forgetOldest() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  std::error_code problem;
  for (fs::directory_iterator it(folder_, problem), end; !problem && it != end; it.increment(problem)) {
    std::error_code ignored;
    if (it->path().extension() == ".json") all.emplace_back(it->last_write_time(ignored), it->path());
  }
  if (all.size() <= kMost) return;
  std::sort(all.begin(), all.end());
  for (size_t i = 0; i + kMost < all.size(); ++i) fs::remove(all[i].second, problem);
}

}  // namespace glint
