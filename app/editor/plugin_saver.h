// The dialog that makes a mix of terms a plugin: asks for its id and writes the short file.
#pragma once

#include <map>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "materials/model_mix.h"
#include "materials/model_registry.h"

namespace glint {

// Why a plugin of that id cannot be written there; empty when it can.
std::string pluginRefusal(const std::string& id, const std::filesystem::path& folder, const ModelRegistry&);

class PluginSaver {
 public:
  void open(const ModelMix&, const std::map<std::string, float>& values, const ModelRegistry&);
  // Once a frame, outside of all windows. The new model's id in the frame in which its file was written; the registry
  // has not read it yet.
  std::optional<std::string> draw(const ModelRegistry&);

 private:
  ModelMix mix_;
  std::map<std::string, float> values_;   // of its parameters
  std::string id_, problem_;
  std::vector<std::string> folders_;
  int folder_ = 0;
  bool asked_ = false, appearing_ = false;
};

}  // namespace glint
