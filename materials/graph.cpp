#include "materials/graph.h"

#include <algorithm>

namespace glint {

bool validNodeId(std::string_view id) {
  return !id.empty() && id.size() <= kLongestNodeId && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

std::string_view name(DocumentKind kind) {
  switch (kind) {
    case DocumentKind::Material: return "material";
    case DocumentKind::Function: return "function";
    case DocumentKind::Layer: return "layer";
  }
  return "";
}

std::optional<DocumentKind> documentKind(std::string_view wanted) {
  for (const auto kind : {DocumentKind::Material, DocumentKind::Function, DocumentKind::Layer})
    if (name(kind) == wanted) return kind;
  return std::nullopt;
}

bool Material::operator==(const Material& other) const {
  return kind == other.kind && name == other.name && doc == other.doc && model == other.model &&
         modelParameters == other.modelParameters && nodes == other.nodes && layout == other.layout &&
         extra == other.extra;
}

const Node* Material::node(std::string_view id) const {
  const auto found = nodes.find(NodeId(id));
  return found == nodes.end() ? nullptr : &found->second;
}

NodeId Material::outputNode() const {
  for (const auto& [id, node] : nodes)
    if (node.kind == "output") return id;
  return {};
}

std::string Material::modelPlace() const {
  return lines && lines->model > 0 ? fmt::format("{}:{}", place(), lines->model) : place();
}

std::string Material::place(std::string_view node, std::string_view pin) const {
  std::string text = file.empty() ? (name.empty() ? "material" : name) : file.string();
  if (node.empty()) return text;
  if (lines) {
    int line = 0;
    if (const auto at = lines->pins.find({NodeId(node), std::string(pin)}); at != lines->pins.end())
      line = at->second;
    else if (const auto whole = lines->nodes.find(NodeId(node)); whole != lines->nodes.end())
      line = whole->second;
    if (line > 0) text += fmt::format(":{}", line);
  }
  text += fmt::format(": node '{}'", node);
  if (!pin.empty()) text += fmt::format(" pin '{}'", pin);
  return text;
}

Material newMaterial(std::string name, std::string model) {
  Material material;
  material.name = std::move(name);
  material.model = std::move(model);
  material.nodes["output"].kind = "output";
  material.layout["output"] = {};
  return material;
}

NodeId freeNodeId(const Material& material, std::string_view wish) {
  NodeId base;
  for (const char c : wish) base += validNodeId({&c, 1}) ? c : '-';
  if (base.empty()) base = "node";
  // Room for a number, and none to begin with: a copy of "noise7" is "noise8", not "noise72".
  base.resize(std::min(base.size(), kLongestNodeId - 8));
  if (!material.nodes.count(base)) return base;
  while (base.size() > 1 && base.back() >= '0' && base.back() <= '9') base.pop_back();
  for (int number = 2;; ++number) {
    NodeId id = base + std::to_string(number);
    if (!material.nodes.count(id)) return id;
  }
}

std::vector<PinRef> wiresFrom(const Material& material, std::string_view node, std::string_view pin) {
  std::vector<PinRef> ends;
  for (const auto& [id, n] : material.nodes)
    for (const auto& [name, input] : n.inputs)
      if (input.from && input.from->node == node && (pin.empty() || input.from->pin == pin))
        ends.push_back({id, name});
  return ends;
}

namespace {

const Json* setting(const Node& node, std::string_view key) {
  const auto found = node.settings.find(std::string(key));
  return found == node.settings.end() ? nullptr : &found->second;
}

}  // namespace

std::string settingText(const Node& node, std::string_view key, std::string_view fallback) {
  const Json* json = setting(node, key);
  return json && json->isString() ? json->text : std::string(fallback);
}

float settingNumber(const Node& node, std::string_view key, float fallback) {
  const Json* json = setting(node, key);
  return json && json->isNumber() ? static_cast<float>(json->number) : fallback;
}

bool settingBool(const Node& node, std::string_view key, bool fallback) {
  const Json* json = setting(node, key);
  return json && json->isBool() ? json->boolean : fallback;
}

}  // namespace glint
