// The scene that each material was last looked at in. A material's file says nothing of lights or spheres, yet setting
// them up is work: it is kept beside the session, one small file for each material, and never in the material itself.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/preview.h"

namespace glint {

class SceneStore {
 public:
  // An empty folder keeps nothing.
  explicit SceneStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // What was kept for a material's file. A damaged one is left aside whole, with one warning.
  std::optional<Preview> read(const std::filesystem::path& material, Diagnostics& warnings) const;
  // Replaces it; of more than 256 scenes the oldest go.
  Diagnostics write(const std::filesystem::path& material, const Preview&) const;

 private:
  std::filesystem::path fileOf(const std::filesystem::path& material) const;
  void forgetOldest() const;

  std::filesystem::path folder_;
};

}  // namespace glint
