#include "materials/function_library.h"

#include <algorithm>

#include "materials/base/files.h"
#include "materials/front_matter.h"
#include "materials/material_json.h"
#include "materials/path_guard.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr std::string_view kFolder = "materials/functions";

Result<MaterialPtr> parseFunction(const std::string& text, const std::filesystem::path& file) {
  // Which kinds of node there are is asked of the graph when it is compiled; here an unknown one is kept.
  static const NodeRegistry registry(std::span<const std::pair<std::string, std::string>>{});
  auto material = parseMaterial(text, file, registry);
  if (!material) return material.diagnostics();
  if (material->kind == DocumentKind::Material)
    return error(file.string(), "is a material, not a function",
                 "a function's file says \"glint\": \"function\" or \"layer\"");
  return std::make_shared<const Material>(std::move(*material));
}

}  // namespace

Result<MaterialPtr> FunctionLibrary::find(const std::string& name, const std::filesystem::path& folder) const {
  if (name.empty()) return error("function", "has no name", "choose a shipped function or a file");
  const std::lock_guard lock(mutex_);
  if (const auto given = given_.find(name); given != given_.end()) return given->second;

  // A bare word is a shipped function, anything else a file.
  std::filesystem::path file;
  std::string shippedPath;
  if (validNodeId(name)) {
    shippedPath = fmt::format("{}/{}.json", kFolder, name);
    file = shipped::onDisk(shippedPath);
  } else {
    auto resolved = resolveInside(folder, name);
    if (!resolved) return resolved.diagnostics();
    file = *resolved;
  }

  const std::string key = file.empty() ? shippedPath : file.string();
  std::error_code failed;
  std::filesystem::file_time_type time{};
  std::uintmax_t size = 0;
  if (!file.empty()) {
    time = std::filesystem::last_write_time(file, failed);
    if (!failed) size = std::filesystem::file_size(file, failed);
  }
  if (const auto entry = entries_.find(key);
      !failed && entry != entries_.end() && entry->second.time == time && entry->second.size == size)
    return *entry->second.result;

  Result<MaterialPtr> result = [&]() -> Result<MaterialPtr> {
    if (!shippedPath.empty()) {
      const auto text = shipped::read(shippedPath);
      if (!text) {
        std::vector<std::string> known;
        for (const std::string& path : shipped::list(kFolder, ".json"))
          known.push_back(std::filesystem::path(path).stem().string());
        return error(fmt::format("function '{}'", name), "is unknown", suggestion(name, known));
      }
      return parseFunction(*text, file.empty() ? std::filesystem::path(shippedPath) : file);
    }
    auto text = readFile(file, kLargestMaterialFile);
    if (!text) return text.diagnostics();
    return parseFunction(*text, file);
  }();
  if (!failed) entries_[key] = {time, size, std::make_shared<const Result<MaterialPtr>>(result)};
  return result;
}

std::vector<std::string> FunctionLibrary::names() const {
  std::vector<std::string> list;
  for (const std::string& path : shipped::list(kFolder, ".json"))
    list.push_back(std::filesystem::path(path).stem().string());
  const std::lock_guard lock(mutex_);
  for (const auto& [name, material] : given_)
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  std::sort(list.begin(), list.end());
  return list;
}

void FunctionLibrary::put(const std::string& name, Material material) {
  const std::lock_guard lock(mutex_);
  given_[name] = std::make_shared<const Material>(std::move(material));
}

FunctionSignature signatureOf(const Material& function) {
  struct Sortable {
    float order;
    FunctionSignature::Port port;
  };
  std::vector<Sortable> inputs, outputs;
  for (const auto& [id, node] : function.nodes) {
    const bool input = node.kind == "function-input";
    if (!input && node.kind != "function-output") continue;
    FunctionSignature::Port port;
    port.node = id;
    port.name = settingText(node, "name");
    if (port.name.empty()) port.name = id;
    port.doc = settingText(node, "doc");
    port.type = valueType(settingText(node, "type", "float")).value_or(ValueType::Float);
    port.minimum = settingNumber(node, "min", 0);
    port.maximum = settingNumber(node, "max", 1);
    port.standard.type = port.type;
    port.surface = settingText(node, "surface", "none");
    const ValueType surfaceType = port.surface.starts_with("uv") ? ValueType::Vec2 : ValueType::Vec3;
    if (!input || port.surface == "none" || port.type != surfaceType) port.surface.clear();
    if (const auto value = node.settings.find("value"); value != node.settings.end())
      port.standard = valueFromJson(value->second, port.type).value_or(port.standard);
    (input ? inputs : outputs).push_back({settingNumber(node, "order", 0), std::move(port)});
  }
  const auto sorted = [](std::vector<Sortable>& list) {
    std::stable_sort(list.begin(), list.end(), [](const Sortable& a, const Sortable& b) {
      return a.order != b.order ? a.order < b.order : a.port.name < b.port.name;
    });
    std::vector<FunctionSignature::Port> ports;
    for (Sortable& item : list) ports.push_back(std::move(item.port));
    return ports;
  };
  return {sorted(inputs), sorted(outputs)};
}

}  // namespace glint
