#include "materials/node_registry.h"

#include <algorithm>

#include "materials/glsl_cost.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr std::string_view kIncludes = "shaders/nodes/lib";

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

}  // namespace

NodeRegistry::NodeRegistry() {
  for (const std::string& path : shipped::list(kIncludes, ".glsl"))
    includes_[stem(path)] = shipped::read(path).value_or("");
  for (NodeKind& kind : builtinNodeKinds()) add(std::move(kind));
  for (const std::string& path : shipped::list("shaders/nodes", ".glsl"))
    addFile(path, shipped::read(path).value_or(""));
}

NodeRegistry::NodeRegistry(std::span<const std::pair<std::string, std::string>> files) {
  for (NodeKind& kind : builtinNodeKinds()) add(std::move(kind));
  for (const auto& [file, text] : files) addFile(file, text);
}

void NodeRegistry::addFile(const std::string& file, const std::string& text) {
  auto kind = parseNodeKind(file, text);
  if (!kind) {
    problems_.insert(problems_.end(), kind.diagnostics().begin(), kind.diagnostics().end());
    return;
  }
  bool good = true;
  for (const std::string& name : kind->includes)
    if (!includes_.count(name)) {
      std::vector<std::string> known;
      for (const auto& [include, source] : includes_) known.push_back(include);
      problems_.push_back(error(file, fmt::format("includes '{}', which is not there", name), suggestion(name, known)));
      good = false;
    }
  if (const NodeKind* other = find(kind->id)) {
    problems_.push_back(error(file, fmt::format("id '{}' is taken{}", kind->id,
                                                other->file.empty() ? "" : " by " + other->file),
                              "give it another id"));
    good = false;
  }
  if (!good) return;
  std::string whole = kind->source;
  for (const std::string& name : kind->includes) whole += "\n" + includes_.at(name);
  kind->operations = glslOperations(whole, kind->function);
  add(std::move(*kind));
}

void NodeRegistry::add(NodeKind kind) {
  auto pins = std::make_shared<NodePins>(NodePins{kind.inputs, kind.outputs});
  const std::string id = kind.id;
  kinds_.emplace(id, Entry{std::move(kind), std::move(pins)});
}

const NodeKind* NodeRegistry::find(std::string_view id) const {
  const auto found = kinds_.find(id);
  return found == kinds_.end() ? nullptr : &found->second.kind;
}

std::vector<const NodeKind*> NodeRegistry::all() const {
  std::vector<const NodeKind*> list;
  for (const auto& [id, entry] : kinds_) list.push_back(&entry.kind);
  std::stable_sort(list.begin(), list.end(), [](const NodeKind* a, const NodeKind* b) {
    return std::tie(a->category, a->title) < std::tie(b->category, b->title);
  });
  return list;
}

std::vector<std::string> NodeRegistry::ids() const {
  std::vector<std::string> list;
  for (const auto& [id, entry] : kinds_) list.push_back(id);
  return list;
}

const std::string* NodeRegistry::include(std::string_view name) const {
  const auto found = includes_.find(name);
  return found == includes_.end() ? nullptr : &found->second;
}

NodePinsPtr NodeRegistry::pins(const NodeKind& kind) const { return kinds_.find(kind.id)->second.pins; }

}  // namespace glint
