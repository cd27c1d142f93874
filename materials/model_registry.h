// Every shading model there is: those of shaders/models/ and of the user's folders.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "materials/model.h"

namespace glint {

using ModelPtr = std::shared_ptr<const ShadingModel>;

// Where get() says that nothing has that id, unlike faults of the file that should.
std::string unknownModelPlace(std::string_view id);

class ModelRegistry {
 public:
  // Reads the shipped models, then each folder's files of models (model_file.h) in order, the folder models/ of the
  // user's configuration last. Hidden files are left out; a link is followed; files over 256 KiB are an error.
  // Two files with one id: the first is used, the second is an error that names both. Faults never stop the others:
  // see problems().
  // `files` are single plugins, whose folders are not looked at; they come before the folders'.
  explicit ModelRegistry(std::vector<std::filesystem::path> folders = {}, std::vector<std::filesystem::path> files = {});

  // An id may also be a mix of terms, or the literature's name for one (model_mix.h), which is made at its first use. Any
  // thread may ask.
  ModelPtr find(std::string_view id) const;      // null when unknown
  Result<ModelPtr> get(std::string_view id) const;  // an unknown id names its nearest neighbour
  // A model as a user names it: what get() takes, or the path of a file of any kind that a model can be, which is read once
  // and need not lie in a folder of this. What was said beside the model comes with its first reading. Any thread may ask.
  Result<ModelPtr> named(const std::string& idOrFile, Diagnostics* warnings = nullptr) const;
  std::vector<ModelPtr> all() const;             // sorted by id
  std::vector<std::string> ids() const;
  // Models that nothing can name, because another file has their id: never drawn, but there.
  const std::vector<ModelPtr>& hidden() const { return hidden_; }
  // What is wrong with the files as they are now: errors, whose file has no model or keeps its last good one, and
  // warnings.
  const Diagnostics& problems() const { return problems_; }
  // Of those what is worth saying whatever is done with a model, as warnings: also that a file has lost its id.
  Diagnostics warnings() const;
  const std::vector<std::filesystem::path>& folders() const { return folders_; }

  // Looks at the folders again (cheap: times and sizes first). True when any model or problem changed.
  bool refresh();

 private:
  struct File {
    std::filesystem::file_time_type time;
    uintmax_t size = 0;
    uint64_t hash = 0;
    bool read = false;
    bool young = false;     // changed so shortly before it was read that time and size cannot tell
    std::filesystem::path behind;  // another file that the model is made of
    std::filesystem::file_time_type behindTime = std::filesystem::file_time_type::min();
    ModelPtr model;         // last good one
    Diagnostics problems;   // of the text as it is now
  };
  // Models that no folder has, by what was asked for.
  struct Made {
    std::mutex mutex;
    std::map<std::string, Result<ModelPtr>, std::less<>> mixes, files;
  };
  Result<ModelPtr> mix(std::string_view id) const;
  std::vector<std::filesystem::path> listFiles(Diagnostics&) const;
  bool readAgain(const std::filesystem::path&, File&);
  std::vector<std::filesystem::path> folders_, single_;
  std::map<std::filesystem::path, File> files_;
  std::map<std::string, ModelPtr, std::less<>> models_;
  std::vector<ModelPtr> hidden_;
  std::shared_ptr<Made> made_ = std::make_shared<Made>();
  Diagnostics problems_;
};

}  // namespace glint
