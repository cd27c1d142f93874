// From a compiled material to what the renderer draws: its textures loaded, its parameters as bytes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "materials/base/diagnostic.h"
#include "materials/compiled_material.h"
#include "renderer/image.h"
#include "renderer/scene.h"

namespace glint {

// The pictures that materials sample, each read once for each colour space: the renderer makes one device
// texture of each pointer, so two colour spaces need two. Safe to use from several threads.
class TextureCache {
 public:
  // `file` as in TextureSlot: a path, or "gltf:PATH#N" (put() by a loader, else read from PATH now). Null
  // (white) for an empty name. What cannot be read becomes missingTexture(), and `problems` says why, with
  // `place` in front.
  Image8Ptr get(const std::string& file, ColorSpace, const std::string& place, Diagnostics& problems);
  // Makes a picture known under a name, so that get() does not look for a file.
  void put(const std::string& name, Image8Ptr);
  // Forgets the files that changed on disk since they were read, and those that failed. True when any did.
  bool refresh();

 private:
  struct Entry {
    Image8Ptr image;                     // null when it failed
    Diagnostics problems;
    std::filesystem::file_time_type time;
    uintmax_t size = 0;
    bool fromFile = false;
  };
  Entry load(const std::string& file);
  std::mutex mutex_;
  std::map<std::pair<std::string, ColorSpace>, Entry> entries_;
};

// A loud magenta and black checker, so that a missing texture cannot pass for an intended one.
Image8Ptr missingTexture();

// Never fails: what is wrong goes to `problems` (errors, placed "MATERIAL: node 'ID'"), and something visible
// is drawn in its stead. Textures are decoded in parallel.
SurfaceMaterial surfaceMaterial(std::shared_ptr<const CompiledMaterial>, std::shared_ptr<const ShadingModel>,
                                TextureCache&, Diagnostics& problems);

}  // namespace glint
