// From a compiled material to what the renderer draws: its textures loaded, its parameters as bytes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/compiled_material.h"
#include "renderer/image.h"
#include "renderer/scene.h"

namespace glint {

// The pictures that materials sample, each read once. Safe to use from several threads.
class TextureCache {
 public:
  // A picture by the name that a TextureSlot has for it: a path, or "gltf:PATH#N", which must have been put() by
  // whoever opened that model: a material alone does not get to have it read. Null (white) for an empty name.
  // Errors are kept until refresh().
  Result<Image8Ptr> get(const std::string& file);
  // Reads several at once, in parallel.
  void prepare(const std::vector<std::string>& files);
  // Makes a picture known under a name, so that get() does not look for a file.
  void put(const std::string& name, Image8Ptr);
  // Forgets the files that changed on disk since they were read, and those that failed. True when any did.
  bool refresh();

 private:
  struct Entry {
    Result<Image8Ptr> image;
    // Of the file that it was read from; empty for pictures that were put().
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    uintmax_t size = 0;
  };
  Entry load(const std::string& name);

  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

// A loud magenta and black checker, so that a missing texture cannot pass for an intended one.
Image8Ptr missingTexture();

// Never fails: what is wrong goes to `problems` (errors, placed "MATERIAL: node 'ID'"), and missingTexture() is
// drawn where a texture cannot be.
SurfaceMaterial surfaceMaterial(std::shared_ptr<const CompiledMaterial>, std::shared_ptr<const ShadingModel>,
                                TextureCache&, Diagnostics& problems);

}  // namespace glint
