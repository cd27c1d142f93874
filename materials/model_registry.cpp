#include "materials/model_registry.h"

#include <algorithm>
#include <chrono>

#include "materials/base/files.h"
#include "materials/base/hash.h"
#include "materials/brdf_file.h"
#include "materials/model_file.h"
#include "materials/model_mix.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kShippedFolder = "shaders/models";
constexpr size_t kMostFiles = 1000;

// Changes within one tick of the file system's clock keep time and size: a file this young is read again.
constexpr auto kYoung = std::chrono::seconds(2);

}  // namespace

std::string unknownModelPlace(std::string_view id) { return fmt::format("model '{}'", id); }

ModelRegistry::ModelRegistry(std::vector<fs::path> folders, std::vector<fs::path> files)
    : folders_(std::move(folders)), single_(std::move(files)) {
  const fs::path own = configFolder() / "models";
  if (std::find(folders_.begin(), folders_.end(), own) == folders_.end()) folders_.push_back(own);
  refresh();
}

// The files there are now, in the order in which they may claim an id.
std::vector<fs::path> ModelRegistry::listFiles(Diagnostics& problems) const {
  std::vector<fs::path> files;
  for (const std::string& path : shipped::list(kShippedFolder, ".glsl")) {
    const fs::path disk = shipped::onDisk(path);
    files.push_back(disk.empty() ? fs::path(path) : disk);
  }
  for (const fs::path& file : single_)
    if (std::error_code ignored; fs::exists(file, ignored)) files.push_back(file);
  for (const fs::path& folder : folders_) {
    std::error_code code;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
      std::error_code ignored;
      if (isModelFile(entry->path()) && entry->path().filename().string()[0] != '.' &&
          entry->is_regular_file(ignored))
        found.push_back(entry->path());
    }
    // The configuration's own folder need not exist.
    if (code && !(folder == folders_.back() && code == std::errc::no_such_file_or_directory))
      problems.push_back(error(folder.string(), "cannot be read: " + code.message(), "name a folder of .glsl or .brdf files"));
    std::sort(found.begin(), found.end());
    if (found.size() > kMostFiles) {
      problems.push_back(error(folder.string(), fmt::format("holds {} models", found.size()),
                               fmt::format("the first {} are read", kMostFiles)));
      found.resize(kMostFiles);
    }
    for (fs::path& path : found)
      if (std::none_of(files.begin(), files.end(), [&](const fs::path& known) {
            std::error_code ignored;
            return known == path || (known.filename() == path.filename() && fs::equivalent(known, path, ignored));
          }))
        files.push_back(std::move(path));
  }
  return files;
}

// Reads a file when it may have changed. True when its model or its problems did.
bool ModelRegistry::readAgain(const fs::path& path, File& file) {
  std::error_code code;
  const fs::file_time_type time = fs::last_write_time(path, code);
  const uintmax_t size = code ? 0 : fs::file_size(path, code);
  const bool embedded = static_cast<bool>(code) && shipped::read(path.string()).has_value();
  std::error_code ignored;  // a file that is gone has the least of all times
  const fs::file_time_type behindTime = file.behind.empty() ? fs::file_time_type::min() : fs::last_write_time(file.behind, ignored);
  if (file.read && !file.young && (embedded || (time == file.time && size == file.size && behindTime == file.behindTime))) return false;
  file.time = time;
  file.size = size;
  file.behindTime = behindTime;
  const auto isYoung = [now = fs::file_time_type::clock::now()](fs::file_time_type t) { return now - t < kYoung; };
  file.young = !embedded && (isYoung(time) || isYoung(behindTime));
  Result<std::string> text = embedded ? Result<std::string>(*shipped::read(path.string()))
                                      : readFile(path, kLargestModelFile);
  Diagnostics problems;
  if (!text) {
    file.hash = 0;
    problems = text.diagnostics();
  } else {
    uint64_t hash = hashText(*text);
    file.behind = fileBehind(path, *text);
    if (!file.behind.empty()) {
      file.behindTime = fs::last_write_time(file.behind, ignored);
      if (const auto behind = readFile(file.behind, kLargestModelFile)) hash = hashText(*behind, hash);
    }
    if (file.read && file.hash == hash) return false;
    file.hash = hash;
    Diagnostics warnings;
    auto model = readModel(path, *text, warnings);
    if (model) {
      file.model = std::make_shared<const ShadingModel>(std::move(*model));
      file.read = true;
      file.problems = std::move(warnings);
      return true;
    }
    problems = model.diagnostics();
  }
  const bool changed = !file.read || problems != file.problems;
  file.read = true;
  file.problems = std::move(problems);
  return changed;
}

bool ModelRegistry::refresh() {
  Diagnostics problems;
  const std::vector<fs::path> order = listFiles(problems);
  bool changed = false;
  for (auto file = files_.begin(); file != files_.end();) {
    if (std::find(order.begin(), order.end(), file->first) == order.end()) {
      file = files_.erase(file);
      changed = true;
    } else {
      ++file;
    }
  }
  for (const fs::path& path : order) changed |= readAgain(path, files_[path]);

  std::map<std::string, ModelPtr, std::less<>> models;
  std::vector<ModelPtr> hidden;
  for (const fs::path& path : order) {
    const File& file = files_[path];
    problems.insert(problems.end(), file.problems.begin(), file.problems.end());
    if (!file.model) continue;
    const auto [found, fresh] = models.emplace(file.model->id, file.model);
    if (fresh) continue;
    hidden.push_back(file.model);
    problems.push_back(error(fmt::format("{}:{}", path.string(), file.model->idLine),
                               fmt::format("its id '{}' is taken by {}:{}, which is used", file.model->id, found->second->file.string(), found->second->idLine),
                               path.extension() == ".glsl" ? "give it an id of its own" : "give the file another name: that is its id"));
  }
  changed |= problems != problems_;
  models_ = std::move(models);
  hidden_ = std::move(hidden);
  problems_ = std::move(problems);
  return changed;
}

Result<ModelPtr> ModelRegistry::mix(std::string_view id) const {
  constexpr size_t kMost = 1000;  // terms allow about as many
  const std::lock_guard lock(made_->mutex);
  if (const auto found = made_->mixes.find(id); found != made_->mixes.end()) return found->second;
  if (made_->mixes.size() >= kMost) made_->mixes.clear();
  auto model = mixModel(id);
  return made_->mixes
      .emplace(std::string(id), model ? Result<ModelPtr>(std::make_shared<const ShadingModel>(std::move(*model)))
                                      : Result<ModelPtr>(model.diagnostics()))
      .first->second;
}

ModelPtr ModelRegistry::find(std::string_view id) const {
  if (isModelMix(id)) {
    auto made = mix(id);
    return made ? *made : nullptr;
  }
  if (const auto found = models_.find(id); found != models_.end()) return found->second;
  const std::string named = namedMix(id);
  return named.empty() ? nullptr : find(named);
}

Result<ModelPtr> ModelRegistry::get(std::string_view id) const {
  if (isModelMix(id)) return mix(id);
  if (ModelPtr model = find(id)) return model;
  // A model may be unknown because its file is wrong: say so instead of offering another.
  for (const auto& [path, file] : files_)
    if (!file.model && (path.stem() == id || modelIdOfFile(path) == id) && !file.problems.empty()) return file.problems;
  return error(unknownModelPlace(id), "unknown shading model", suggestion(std::string(id), ids()));
}

Result<ModelPtr> ModelRegistry::named(const std::string& idOrFile, Diagnostics* warnings) const {
  const fs::path path = idOrFile;
  std::error_code code;
  if (!isModelFile(path) || find(idOrFile)) return get(idOrFile);
  if (!fs::exists(path, code)) return error(idOrFile, "no such file", "name a model, a mix of terms, or a .glsl, .brdf or .bparam file");
  for (const auto& [known, file] : files_)
    if (known.filename() == path.filename() && fs::equivalent(known, path, code)) {
      if (file.model) return file.model;
      return file.problems;
    }
  const std::lock_guard lock(made_->mutex);
  if (const auto found = made_->files.find(idOrFile); found != made_->files.end()) return found->second;
  Diagnostics said;
  auto model = readModelFile(path, said);
  if (warnings) warnings->insert(warnings->end(), said.begin(), said.end());
  return made_->files
      .emplace(idOrFile, model ? Result<ModelPtr>(std::make_shared<const ShadingModel>(std::move(*model))) : Result<ModelPtr>(model.diagnostics()))
      .first->second;
}

Diagnostics ModelRegistry::warnings() const {
  Diagnostics found;
  const auto isHidden = [&](const Diagnostic& d) {
    return std::any_of(hidden_.begin(), hidden_.end(), [&](const ModelPtr& model) { return d.place == fmt::format("{}:{}", model->file.string(), model->idLine); });
  };
  for (const Diagnostic& d : problems_)
    if (d.severity == Severity::Warning || isHidden(d)) found.push_back(warning(d.place, d.what, d.hint));
  return found;
}

std::vector<ModelPtr> ModelRegistry::all() const {
  std::vector<ModelPtr> result;
  for (const auto& [id, model] : models_) result.push_back(model);
  return result;
}

std::vector<std::string> ModelRegistry::ids() const {
  std::vector<std::string> result;
  for (const auto& [id, model] : models_) result.push_back(id);
  return result;
}

}  // namespace glint
