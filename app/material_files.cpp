#include "app/material_files.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include "materials/base/files.h"
#include "materials/base/utf8.h"
#include "materials/material_json.h"
#include "materials/path_guard.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kGltfPrefix = "gltf:";
constexpr const char* kTextures = "_textures";
constexpr const char* kFunctions = "_functions";

bool liesIn(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

// Names from a model are untrusted, and shall be good anywhere.
std::string plainName(const std::string& name, const std::string& otherwise) {
  std::string plain;
  for (const char c : fs::path(name).filename().string().substr(0, 64)) {
    const bool good = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    if (good || !plain.ends_with('-')) plain += good ? c : '-';
  }
  for (const char* extension : {".png", ".PNG", ".jpg", ".JPG", ".jpeg", ".JPEG"})
    if (plain.ends_with(extension)) plain.resize(plain.size() - std::string_view(extension).size());
  while (plain.starts_with('.') || plain.starts_with('-')) plain.erase(0, 1);
  while (plain.ends_with('.') || plain.ends_with('-')) plain.pop_back();
  return plain.empty() ? otherwise : plain;
}

Diagnostics readable(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {error(file.string(), "no such file", "bring it back, or choose another")};
  if (!fs::is_regular_file(file, ignored)) return {error(file.string(), "is no file", "choose a file")};
  return {};
}

bool holds(const fs::path& file, const std::string& bytes) {
  std::error_code code;
  if (!fs::is_regular_file(file, code) || fs::file_size(file, code) != bytes.size() || code) return false;
  const auto there = readFile(file);
  return there && *there == bytes;
}

}  // namespace

MaterialFiles::MaterialFiles(const NodeRegistry& nodes, std::set<fs::path> named) : nodes_(nodes), named_(std::move(named)) {}

MaterialFiles::~MaterialFiles() { takeBack(0, 0); }

void MaterialFiles::takeBack(size_t files, size_t folders) {
  std::error_code ignored;
  for (; written_.size() > files; written_.pop_back()) {
    fs::remove(written_.back(), ignored);
    auto& there = placed_[written_.back().parent_path()];
    std::erase_if(there, [&](const Placed& placed) { return placed.file == written_.back(); });
  }
  for (; folders_.size() > folders; folders_.pop_back()) fs::remove(folders_.back(), ignored);
}

template <class Visit>
void MaterialFiles::eachName(const Node& node, Visit visit) const {
  const NodeKind* kind = nodes_.find(node.kind);
  if (!kind) return;
  for (const SettingInfo& setting : kind->settings) {
    const bool picture = setting.type == SettingInfo::Type::File, function = setting.type == SettingInfo::Type::Function;
    const std::string name = picture || function ? settingText(node, setting.name) : "";
    // A bare word is a function that ships.
    if (!name.empty() && !(function && validNodeId(name))) visit(picture ? Use::Picture : Use::Function, setting.name, name);
  }
}

Result<Material> MaterialFiles::gather(const Material& material, const fs::path& target) {
  std::error_code code;
  const fs::path from = material.file.parent_path();
  trip_ = {.from = fs::weakly_canonical(from.empty() ? fs::current_path(code) : from, code),
           .to = fs::weakly_canonical(fs::absolute(target, code).parent_path(), code),
           .stem = target.stem().string()};
  if (code) return error(target.string(), "cannot be resolved: " + code.message());
  if (!fs::is_directory(trip_.to, code))
    return error(target.string(), "cannot be written: there is no such folder", "make it, or save somewhere else");
  trip_.stays = !material.file.empty() && trip_.from == trip_.to;
  auto made = gatherOn(trip_, material);
  if (!unwritable_.empty()) return unwritable_;
  return made;
}

Diagnostics MaterialFiles::cannotWrite(Diagnostic problem) {
  if (unwritable_.empty()) unwritable_.push_back(problem);
  return {std::move(problem)};
}

Result<Material> MaterialFiles::gatherOn(Trip& trip, const Material& material) {
  Material moving = material;
  Diagnostics problems;
  for (auto& [id, node] : moving.nodes) {
    const Node before = node;
    eachName(before, [&](Use use, const std::string& setting, const std::string& name) {
      const auto after = moved(trip, use, name);
      if (after) {
        if (*after != name) node.settings[setting] = Json::of(*after);
        return;
      }
      for (const Diagnostic& d : after.diagnostics()) {
        const Diagnostic problem = error(material.place(id), fmt::format("{} {}: {}", use == Use::Picture ? "texture" : "function", d.place, d.what), d.hint);
        if (std::find(problems.begin(), problems.end(), problem) == problems.end()) problems.push_back(problem);
      }
    });
  }
  if (!problems.empty()) return problems;
  return moving;
}

Result<std::string> MaterialFiles::moved(Trip& trip, Use use, const std::string& name) {
  auto& known = use == Use::Picture ? trip.pictures : trip.functions;
  if (const auto found = known.find(name); found != known.end()) return found->second;
  const auto become = [&]() -> Result<std::string> {
    const bool named = use == Use::Picture && named_.count(name) > 0;
    if (use == Use::Picture && name.starts_with(kGltfPrefix)) {
      const size_t hash = name.rfind('#');
      const fs::path model = hash == name.npos ? fs::path() : fs::path(name.substr(kGltfPrefix.size(), hash - kGltfPrefix.size()));
      if (named_.count(model)) return movedModelPicture(trip, name);
      if (trip.stays) return name;
      return error(name.substr(kGltfPrefix.size()), "belongs to a model that is not open", "open the model, or choose a picture file");
    }
    fs::path source = name;
    if (!named) {
      if (trip.stays) return name;
      const auto inside = resolveInside(trip.from, name);
      if (!inside) return inside.diagnostics();
      source = *inside;
    }
    if (const Diagnostics problems = readable(source); !problems.empty()) return problems;
    std::error_code code;
    const fs::path real = fs::weakly_canonical(source, code);
    const std::string within = real.lexically_relative(trip.to).generic_string();
    if (liesIn(real, trip.to) && validUtf8(within) == within) return within;
    if (use == Use::Function) return movedFunction(trip, source);
    const auto bytes = readFile(source);
    if (!bytes) return bytes.diagnostics();
    return write(trip, kTextures, source.filename().string(), *bytes);
  }();
  if (become) known[name] = *become;
  return become;
}

Result<std::string> MaterialFiles::movedFunction(Trip& trip, const fs::path& source) {
  if (!calling_.insert(source).second) return error(source.string(), "calls itself", "break the circle");
  const auto made = [&]() -> Result<std::string> {
    const auto bytes = readFile(source, kLargestMaterialFile);
    if (!bytes) return bytes.diagnostics();
    const auto function = parseMaterial(*bytes, source, nodes_);
    if (!function) return function.diagnostics();
    const auto folder = folderFor(trip, kFunctions);
    if (!folder) return folder.diagnostics();
    Trip inner{.from = source.parent_path(), .to = *folder, .stem = source.stem().string()};
    const auto moving = gatherOn(inner, *function);
    if (!moving) return moving.diagnostics();
    return write(trip, kFunctions, source.filename().string(), *moving == *function ? *bytes : materialText(*moving));
  }();
  calling_.erase(source);
  return made;
}

Result<std::string> MaterialFiles::movedModelPicture(const Trip& trip, const std::string& name) {
  const size_t hash = name.rfind('#');
  const std::string model = name.substr(kGltfPrefix.size(), hash - kGltfPrefix.size()), number = name.substr(hash + 1);
  const std::string place = model + " picture " + number;
  auto found = models_.find(model);
  if (found == models_.end()) found = models_.emplace(model, gltfPictures(model)).first;
  if (!found->second) return found->second.diagnostics();
  const auto& pictures = *found->second;
  const bool digits = !number.empty() && number.size() < 9 && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  const size_t index = digits ? std::stoul(number) : pictures.size();
  if (index >= pictures.size()) return error(place, "is not in the model", "open the model again, or choose a picture file");
  const GltfPicture& picture = pictures[index];
  const bool png = picture.bytes.starts_with("\x89PNG"), jpeg = picture.bytes.starts_with("\xff\xd8");
  if (!png && !jpeg) return error(place, "is neither PNG nor JPEG", "choose a picture file");
  const std::string otherwise = plainName(fs::path(model).stem().string(), "model") + "-" + number;
  return write(trip, kTextures, plainName(picture.name, otherwise) + (png ? ".png" : ".jpg"), picture.bytes);
}

Result<fs::path> MaterialFiles::folderFor(const Trip& trip, const char* suffix) {
  const fs::path folder = trip.to / (trip.stem + suffix);
  std::error_code code;
  if (fs::create_directory(folder, code)) folders_.push_back(folder);
  if (code) return cannotWrite(error(folder.string(), "cannot be made: " + code.message(), "save somewhere else"));
  // A link there may lead anywhere, and what lies outside would not be read.
  const fs::path real = fs::weakly_canonical(folder, code);
  if (code || !liesIn(real, trip.to)) return cannotWrite(error(folder.string(), "leads out of the folder of the material", "remove the link"));
  return real;
}

Result<std::string> MaterialFiles::write(const Trip& trip, const char* suffix, const std::string& wish, const std::string& bytes) {
  const auto folder = folderFor(trip, suffix);
  if (!folder) return folder.diagnostics();
  const fs::path name = validUtf8(wish);
  const size_t hash = std::hash<std::string_view>{}(bytes);
  auto& there = placed_[*folder];
  const auto spelt = [&](const fs::path& file) { return file.lexically_relative(trip.to).generic_string(); };
  for (const Placed& placed : there)
    if (placed.hash == hash && holds(placed.file, bytes)) return spelt(placed.file);
  fs::path file = *folder / name;
  std::error_code code;
  for (int number = 2; fs::symlink_status(file, code).type() != fs::file_type::not_found; ++number) {
    if (code) return cannotWrite(error(file.string(), "cannot be looked at: " + code.message(), "save somewhere else"));
    if (holds(file, bytes)) {
      there.push_back({hash, file});
      return spelt(file);
    }
    file = *folder / fmt::format("{}-{}{}", name.stem().string(), number, name.extension().string());
  }
  const Diagnostics problems = writeFileAtomic(file, bytes);
  if (!problems.empty()) return cannotWrite(problems.front());
  written_.push_back(file);
  there.push_back({hash, file});
  return spelt(file);
}

void MaterialFiles::gatherPast(std::span<const Node* const> nodes) {
  if (trip_.stays) return;
  for (const Node* node : nodes)
    eachName(*node, [&](Use use, const std::string&, const std::string& name) {
      auto& known = use == Use::Picture ? trip_.pictures : trip_.functions;
      if (known.count(name)) return;
      if (use == Use::Function) {
        const size_t files = written_.size(), folders = folders_.size();
        if (!moved(trip_, use, name)) takeBack(files, folders);
        return;
      }
      if (name.starts_with(kGltfPrefix) || named_.count(name)) return;
      const auto inside = resolveInside(trip_.from, name);
      if (!inside) return;
      known[name] = inside->string();
      leftOutside_.push_back(*inside);
    });
}

bool MaterialFiles::movesAny() const {
  const auto differs = [](const auto& names) { return std::any_of(names.begin(), names.end(), [](const auto& n) { return n.first != n.second; }); };
  return differs(trip_.pictures) || differs(trip_.functions);
}

void MaterialFiles::rewrite(Node& node) const {
  const Node before = node;
  eachName(before, [&](Use use, const std::string& setting, const std::string& name) {
    const auto& known = use == Use::Picture ? trip_.pictures : trip_.functions;
    if (const auto found = known.find(name); found != known.end() && found->second != name)
      node.settings[setting] = Json::of(found->second);
  });
}

}  // namespace glint
