#include "renderer/surface_material.h"

#include <algorithm>

#include "renderer/image_io.h"
#include "renderer/parallel.h"

namespace glint {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kGltfPrefix = "gltf:";

}  // namespace

Image8Ptr missingTexture() {
  static const Image8Ptr checker = [] {
    constexpr int kSide = 64, kSquare = 8;
    auto image = std::make_shared<Image8>(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const bool magenta = (x / kSquare + y / kSquare) % 2 == 0;
        image->at(x, y)[0] = image->at(x, y)[2] = magenta ? 255 : 0;
      }
    return image;
  }();
  return checker;
}

TextureCache::Entry TextureCache::load(const std::string& name) {
  if (name.starts_with(kGltfPrefix))
    return {error(name.substr(kGltfPrefix.size()), "belongs to a model that is not open", "open the model, or choose a picture file"), name, {}, 0};
  Entry entry{error(name, "not read"), name, {}, 0};
  std::error_code code;
  // Before the read, so that a change during it is seen by refresh().
  entry.time = fs::last_write_time(name, code);
  entry.size = code ? 0 : fs::file_size(name, code);
  Result<Image8> image = readImage8(name);
  if (image)
    entry.image = Image8Ptr(std::make_shared<const Image8>(std::move(*image)));
  else
    entry.image = image.diagnostics();
  return entry;
}

Result<Image8Ptr> TextureCache::get(const std::string& file) {
  if (file.empty()) return Image8Ptr{};
  {
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(file);
    if (found != entries_.end()) return found->second.image;
  }
  // Without the lock: others go on while this one decodes. Two that want the same file may both read it.
  Entry entry = load(file);
  const std::scoped_lock lock(mutex_);
  return entries_.try_emplace(file, std::move(entry)).first->second.image;
}

void TextureCache::prepare(const std::vector<std::string>& files) {
  std::vector<std::string> wanted = files;
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  parallelFor(wanted.size(), [&](size_t i) { (void)get(wanted[i]); });
}

void TextureCache::put(const std::string& name, Image8Ptr image) {
  const std::scoped_lock lock(mutex_);
  entries_.insert_or_assign(name, Entry{std::move(image), {}, {}, 0});
}

bool TextureCache::refresh() {
  const std::scoped_lock lock(mutex_);
  return std::erase_if(entries_, [](const auto& item) {
           const Entry& entry = item.second;
           if (entry.file.empty()) return false;
           std::error_code code;
           const bool same = fs::last_write_time(entry.file, code) == entry.time && !code &&
                             fs::file_size(entry.file, code) == entry.size && !code;
           return !entry.image.ok() || !same;
         }) > 0;
}

SurfaceMaterial surfaceMaterial(std::shared_ptr<const CompiledMaterial> compiled,
                                std::shared_ptr<const ShadingModel> model, TextureCache& cache, Diagnostics& problems) {
  GLINT_CHECK(compiled && model, "{}", compiled != nullptr);
  SurfaceMaterial surface;
  std::vector<std::string> files;
  for (const TextureSlot& slot : compiled->textures) files.push_back(slot.file);
  cache.prepare(files);
  for (const TextureSlot& slot : compiled->textures) {
    const Result<Image8Ptr> image = cache.get(slot.file);
    if (!image)
      for (const Diagnostic& d : image.diagnostics())
        problems.push_back(error(slot.place, fmt::format("texture {}: {}", d.place, d.what), d.hint));
    surface.textures.push_back(image ? *image : missingTexture());
  }
  surface.block = compiled->block();
  surface.modelParameters = compiled->modelParameterValues();
  surface.compiled = std::move(compiled);
  surface.model = std::move(model);
  return surface;
}

}  // namespace glint
