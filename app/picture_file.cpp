#include "app/picture_file.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "materials/base/hash.h"
#include "materials/base/utf8.h"

namespace glint {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWritten = "write .png (display-referred), or .exr, .hdr, .pfm (linear)";

std::string extension(const fs::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

// Grey becomes three equal channels; grey and alpha, four.
ImageF colours(const Image8& image) {
  const bool grey = image.channels < 3, alpha = image.channels == 2 || image.channels == 4;
  ImageF result(image.width, image.height, alpha ? 4 : 3);
  const size_t count = size_t(image.width) * size_t(image.height), from = size_t(image.channels), to = size_t(result.channels);
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = 0; k < 3; ++k) result.data[i * to + k] = float(image.data[i * from + (grey ? 0 : k)]) / 255;
    if (alpha) result.data[i * to + 3] = float(image.data[i * from + from - 1]) / 255;
  }
  return result;
}

uint64_t hashOf(const Mesh& mesh) {
  const uint64_t vertices = hashBytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  return hashBytes(mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t), vertices);
}

// Whether a file can be written where it is to be.
Diagnostics checkPlace(const fs::path& file, const std::string& place) {
  std::error_code ignored;
  const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
  if (!fs::is_directory(folder, ignored))
    return {error(place, fmt::format("there is no folder '{}'", folder.string()), "make it first")};
  if (::access(folder.c_str(), W_OK) != 0)
    return {error(place, fmt::format("the folder '{}' cannot be written to", folder.string()), "choose another")};
  if (fs::is_directory(file, ignored)) return {error(place, fmt::format("'{}' is a folder", file.string()), "name a file")};
  return {};
}

}  // namespace

std::optional<PictureKind> pictureKind(const fs::path& file) {
  const std::string end = extension(file);
  if (end == ".png" || end == ".jpg" || end == ".jpeg") return PictureKind::Display;
  if (end == ".exr" || end == ".hdr" || end == ".pfm") return PictureKind::Linear;
  return std::nullopt;
}

Result<PictureKind> checkOutput(const fs::path& file, const std::string& place) {
  const auto kind = pictureKind(file);
  if (!kind || (*kind == PictureKind::Display && extension(file) != ".png"))
    return error(place, fmt::format("'{}' is no picture that Glint writes", file.string()), kWritten);
  if (Diagnostics problems = checkPlace(file, place); !problems.empty()) return problems;
  return *kind;
}

Diagnostics checkOutput(const fs::path& file, const std::string& place, const std::string& kind, const std::vector<std::string>& extensions) {
  if (std::find(extensions.begin(), extensions.end(), extension(file)) != extensions.end()) return checkPlace(file, place);
  std::string list = extensions.back();
  if (extensions.size() > 1) list = fmt::format("{} or {}", fmt::join(extensions.begin(), extensions.end() - 1, ", "), list);
  return {error(place, fmt::format("'{}' is no {}", file.string(), kind), fmt::format("name a {} file", list))};
}

Result<ReadPicture> readPicture(const fs::path& file) {
  const auto kind = pictureKind(file);
  if (!kind) return error(file.string(), "is not a picture by its name", "give a .png, .jpg, .exr, .hdr or .pfm file");
  if (*kind == PictureKind::Display) {
    auto image = readImage8(file);
    if (!image) return image.diagnostics();
    return ReadPicture{*kind, colours(*image)};
  }
  auto image = readImageF(file);
  if (!image) return image.diagnostics();
  for (size_t i = 0; i < image->data.size(); ++i) {
    if (std::isfinite(image->data[i])) continue;
    const size_t pixel = i / size_t(image->channels);
    return error(file.string(), fmt::format("holds {} at {},{}", std::isnan(image->data[i]) ? "NaN" : "infinity",
                                            pixel % size_t(image->width), pixel / size_t(image->width)),
                 "a picture to compare must be finite");
  }
  return ReadPicture{*kind, std::move(*image)};
}

ImageF linearFromDisplay(const ImageF& image) {
  ImageF result = image;
  for (size_t i = 0; i < result.data.size(); ++i)
    if (image.channels < 4 || i % 4 != 3) result.data[i] = linearFromSrgb(result.data[i]);
  return result;
}

ImageF linearFromDisplay(const Image8& image) { return linearFromDisplay(colours(image)); }

Diagnostics tonemapWarning(const Arguments& arguments, const fs::path& file, PictureKind kind) {
  if (kind == PictureKind::Display || !arguments.has("tonemap")) return {};
  return {warning("--tonemap", fmt::format("has no effect on '{}', which is linear", file.string()), "write a .png for a tone map")};
}

Diagnostic invalidPixelsWarning(const fs::path& file, int count) {
  return warning(file.string(), fmt::format("{} pixels were not finite and are black", count),
                 "the shading model or the material returns NaN or infinity there");
}

ImageNotes pictureNotes(const Arguments& arguments, const gl::Context& context, std::span<const Scene> scenes) {
  ImageNotes notes;
  notes["Software"] = "Glint " GLINT_VERSION;
  notes["Command"] = arguments.commandLine;
  notes["OpenGL renderer"] = context.info().renderer;
  notes["OpenGL version"] = context.info().version;
  // Names are anybody's text, so they stand in values: one line "hash name" for each.
  std::map<std::string, std::set<std::string>> lists;
  const auto list = [&](const char* kind, uint64_t hash, const std::string& name) {
    lists[kind].insert(hashName(hash) + " " + (name.empty() ? "unnamed" : onOneLine(name)));
  };
  std::set<const void*> meshes;
  for (const Scene& scene : scenes) {
    if (scene.environment) list("Environments", scene.environment->hash, scene.environment->name);
    for (const SurfaceMaterial& material : scene.materials) {
      if (material.model) list("Models", material.model->hash, material.model->id);
      if (material.compiled) {
        // One material may be drawn with several values or models: each counts.
        uint64_t hash = hashBytes(material.block.data(), material.block.size(), material.compiled->hash);
        for (const Value& value : material.modelParameters) hash = hashBytes(value.v.data(), sizeof(value.v), hash);
        list("Materials", hash, material.compiled->name);
      }
    }
    for (const Instance& instance : scene.instances)
      if (instance.mesh && meshes.insert(instance.mesh.get()).second) list("Meshes", hashOf(*instance.mesh), instance.mesh->name);
  }
  for (const auto& [kind, lines] : lists) notes[kind] = fmt::format("{}", fmt::join(lines, "\n"));
  return notes;
}

}  // namespace glint
