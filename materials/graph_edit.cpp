#include "materials/graph_edit.h"

#include <algorithm>

#include "materials/node_registry.h"

namespace glint {
namespace {

template <class T>
bool same(const Edit::Change<T>& change) {
  return change.before == change.after;
}

template <class Map>
void applyChanges(Map& values, const auto& changes, bool forward) {
  for (const auto& [id, change] : changes) {
    const auto& target = forward ? change.after : change.before;
    if (target)
      values.insert_or_assign(id, *target);
    else
      values.erase(id);
  }
}

// Appends what `later` does to what `first` did: the earliest before, the latest after.
template <class Changes>
void chain(Changes& first, const Changes& later) {
  for (const auto& [id, change] : later) {
    const auto [at, fresh] = first.try_emplace(id, change);
    if (!fresh) at->second.after = change.after;
    if (same(at->second)) first.erase(at);
  }
}

void chainEdit(Edit& first, const Edit& later) {
  chain(first.nodes, later.nodes);
  chain(first.layout, later.layout);
  if (later.header) {
    if (first.header)
      first.header->after = later.header->after;
    else
      first.header = later.header;
    if (same(*first.header)) first.header.reset();
  }
}

std::string countLabel(const char* verb, size_t count, const NodeId& first) {
  return count == 1 ? fmt::format("{} {}", verb, first) : fmt::format("{} {} nodes", verb, count);
}

// Whether `from` is fed, over any number of wires, by `to`: a wire from -> to would then close a circle.
bool feeds(const Material& material, const NodeId& to, const NodeId& from) {
  std::vector<NodeId> todo{from};
  std::set<NodeId> seen;
  while (!todo.empty()) {
    const NodeId id = std::move(todo.back());
    todo.pop_back();
    if (id == to) return true;
    if (!seen.insert(id).second) continue;
    if (const Node* node = material.node(id))
      for (const auto& [pin, input] : node->inputs)
        if (input.from) todo.push_back(input.from->node);
  }
  return false;
}

}  // namespace

Clip copyNodes(const Material& material, const std::set<NodeId>& ids) {
  Clip clip;
  for (const NodeId& id : ids) {
    const Node* node = material.node(id);
    if (!node) continue;
    clip.nodes[id] = *node;
    if (const auto at = material.layout.find(id); at != material.layout.end()) clip.layout[id] = at->second;
  }
  return clip;
}

GraphEditor::GraphEditor(Material material) : material_(std::move(material)) {}

Diagnostics GraphEditor::refuse(std::string_view node, std::string_view pin, std::string what,
                                std::string hint) {
  return {error(material_.place(node, pin), std::move(what), std::move(hint))};
}

Diagnostics GraphEditor::missing(const NodeId& id) {
  std::vector<std::string> ids;
  for (const auto& [known, node] : material_.nodes) ids.push_back(known);
  return refuse({}, {}, fmt::format("has no node '{}'", id), suggestion(id, ids));
}

std::optional<Position> GraphEditor::placeOf(const NodeId& id) const {
  const auto at = material_.layout.find(id);
  if (at == material_.layout.end()) return std::nullopt;
  return at->second;
}

Diagnostics GraphEditor::addNode(std::string_view kind, Position at, NodeId* made) {
  return addNode(Node{.kind = std::string(kind)}, at, kind, made);
}

Diagnostics GraphEditor::addNode(Node node, Position at, std::string_view wishedId, NodeId* made) {
  if (node.kind.empty()) return refuse({}, {}, "a node needs a kind");
  const NodeId id = freeNodeId(material_, wishedId);
  Edit edit{.label = fmt::format("Add {}", id)};
  edit.nodes[id].after = std::move(node);
  edit.layout[id] = {placeOf(id), at};
  if (made) *made = id;
  return commit(std::move(edit));
}

Diagnostics GraphEditor::removeNodes(const std::set<NodeId>& ids) {
  if (ids.empty()) return {};
  size_t outputs = 0;
  for (const auto& [id, node] : material_.nodes) outputs += node.kind == "output";
  for (const NodeId& id : ids) {
    const Node* node = material_.node(id);
    if (!node) return missing(id);
    if (node->kind == "output" && --outputs == 0)
      return refuse(id, {}, "is the material's only output and cannot be removed");
  }
  Edit edit{.label = countLabel("Remove", ids.size(), *ids.begin())};
  for (const auto& [id, node] : material_.nodes) {
    if (ids.count(id)) {
      edit.nodes[id].before = node;
      edit.layout[id].before = placeOf(id);
      continue;
    }
    Node cut = node;
    for (auto input = cut.inputs.begin(); input != cut.inputs.end();) {
      if (input->second.from && ids.count(input->second.from->node)) input->second.from.reset();
      input = input->second.empty() ? cut.inputs.erase(input) : std::next(input);
    }
    if (cut != node) edit.nodes[id] = {node, std::move(cut)};
  }
  return commit(std::move(edit));
}

Diagnostics GraphEditor::changeNode(const NodeId& id, std::string label, Node after) {
  Edit edit{.label = std::move(label)};
  edit.nodes[id] = {material_.nodes.at(id), std::move(after)};
  return commit(std::move(edit));
}

Diagnostics GraphEditor::connect(const PinRef& from, const PinRef& to) {
  if (!material_.node(from.node)) return missing(from.node);
  if (!material_.node(to.node)) return missing(to.node);
  if (from.pin.empty() || to.pin.empty()) return refuse(to.node, to.pin, "a wire needs a pin at both ends");
  if (feeds(material_, to.node, from.node))
    return refuse(to.node, to.pin, fmt::format("a wire from '{}' would close a circle", from.node),
                  "a node cannot depend on its own result");
  Node after = *material_.node(to.node);
  after.inputs[to.pin].from = from;
  return changeNode(to.node, fmt::format("Connect {}", to.text()), std::move(after));
}

Diagnostics GraphEditor::disconnect(const PinRef& to) {
  const Node* node = material_.node(to.node);
  if (!node) return missing(to.node);
  Node after = *node;
  const auto input = after.inputs.find(to.pin);
  if (input == after.inputs.end() || !input->second.from) return {};
  input->second.from.reset();
  if (input->second.empty()) after.inputs.erase(input);
  return changeNode(to.node, fmt::format("Disconnect {}", to.text()), std::move(after));
}

Diagnostics GraphEditor::setValue(const PinRef& pin, const Value& value) {
  const Node* node = material_.node(pin.node);
  if (!node) return missing(pin.node);
  if (componentCount(value.type) == 0) return refuse(pin.node, pin.pin, "no constant has this type");
  Node after = *node;
  after.inputs[pin.pin].value = value;
  return changeNode(pin.node, fmt::format("Set {}", pin.text()), std::move(after));
}

Diagnostics GraphEditor::resetValue(const PinRef& pin) {
  const Node* node = material_.node(pin.node);
  if (!node) return missing(pin.node);
  Node after = *node;
  const auto input = after.inputs.find(pin.pin);
  if (input == after.inputs.end()) return {};
  input->second.value.reset();
  if (input->second.empty()) after.inputs.erase(input);
  return changeNode(pin.node, fmt::format("Reset {}", pin.text()), std::move(after));
}

Diagnostics GraphEditor::setSetting(const NodeId& id, const std::string& key, const Json& value) {
  const Node* node = material_.node(id);
  if (!node) return missing(id);
  if (key == "kind" || key == "inputs") return refuse(id, {}, fmt::format("'{}' is no setting", key));
  Node after = *node;
  after.settings[key] = value;
  return changeNode(id, fmt::format("Set {} {}", id, key), std::move(after));
}

Diagnostics GraphEditor::resetSetting(const NodeId& id, const std::string& key) {
  const Node* node = material_.node(id);
  if (!node) return missing(id);
  Node after = *node;
  after.settings.erase(key);
  return changeNode(id, fmt::format("Reset {} {}", id, key), std::move(after));
}

Diagnostics GraphEditor::move(const std::map<NodeId, Position>& places) {
  if (places.empty()) return {};
  Edit edit{.label = countLabel("Move", places.size(), places.begin()->first)};
  for (const auto& [id, to] : places) {
    if (!material_.node(id)) return missing(id);
    edit.layout[id] = {placeOf(id), to};
  }
  return commit(std::move(edit));
}

Diagnostics GraphEditor::rename(const NodeId& from, const NodeId& to) {
  if (!material_.node(from)) return missing(from);
  if (from == to) return {};
  if (!validNodeId(to))
    return refuse(from, {}, fmt::format("cannot be called '{}'", to.substr(0, 100)),
                  "letters, digits, '-' and '_', at most 64");
  if (material_.node(to)) return refuse(from, {}, fmt::format("there is a node '{}' already", to));
  Edit edit{.label = fmt::format("Rename {} to {}", from, to)};
  for (const auto& [id, node] : material_.nodes) {
    Node after = node;
    for (auto& [pin, input] : after.inputs)
      if (input.from && input.from->node == from) input.from->node = to;
    if (id == from) {
      edit.nodes[from].before = node;
      edit.nodes[to].after = std::move(after);
    } else if (after != node) {
      edit.nodes[id] = {node, std::move(after)};
    }
  }
  if (const auto at = placeOf(from)) {
    edit.layout[from].before = at;
    edit.layout[to] = {placeOf(to), at};
  }
  return commit(std::move(edit));
}

Diagnostics GraphEditor::replaceNode(const NodeId& id, std::string_view kind, const GraphContext& context) {
  const Node* node = material_.node(id);
  if (!node) return missing(id);
  const NodeKind* known = context.nodes.find(kind);
  if (!known)
    return refuse(id, {}, fmt::format("unknown kind '{}'", kind), suggestion(std::string(kind), context.nodes.ids()));
  if (node->kind == "output")
    return refuse(id, {}, "the output stays what it is");

  Node after{.kind = known->id};
  for (const SettingInfo& setting : known->settings)
    if (const auto old = node->settings.find(setting.name); old != node->settings.end())
      after.settings.insert(*old);
  const std::filesystem::path folder = material_.file.parent_path();
  const NodePinsPtr oldPins = pinsOf(*node, context, folder), newPins = pinsOf(after, context, folder);
  const auto counterpart = [](const std::vector<Pin>& from, const std::vector<Pin>& to,
                              const std::string& pin) -> std::string {
    for (const Pin& p : to)
      if (p.name == pin) return pin;
    for (size_t i = 0; i < from.size() && i < to.size(); ++i)
      if (from[i].name == pin) return to[i].name;
    return {};
  };
  for (const auto& [pin, input] : node->inputs)
    if (const std::string to = counterpart(oldPins->inputs, newPins->inputs, pin); !to.empty())
      after.inputs.try_emplace(to, input);

  Edit edit{.label = fmt::format("Replace {}", id)};
  for (const auto& [otherId, other] : material_.nodes) {
    Node rewired = otherId == id ? after : other;
    for (auto input = rewired.inputs.begin(); input != rewired.inputs.end();) {
      if (input->second.from && input->second.from->node == id) {
        const std::string to = counterpart(oldPins->outputs, newPins->outputs, input->second.from->pin);
        if (to.empty())
          input->second.from.reset();
        else
          input->second.from->pin = to;
      }
      input = input->second.empty() ? rewired.inputs.erase(input) : std::next(input);
    }
    if (rewired != other) edit.nodes[otherId] = {other, std::move(rewired)};
  }
  return commit(std::move(edit));
}

Diagnostics GraphEditor::paste(const Clip& clip, Position at, std::vector<NodeId>* made) {
  if (made) made->clear();
  if (clip.nodes.empty()) return {};
  // Ids are taken one after the other, so each must be visible to the next.
  Material preview;
  for (const auto& [id, node] : material_.nodes) preview.nodes[id];
  std::map<NodeId, NodeId> ids;
  for (const auto& [id, node] : clip.nodes) {
    ids[id] = freeNodeId(preview, id);
    preview.nodes[ids[id]];
  }
  Position corner{1e30f, 1e30f};
  for (const auto& [id, place] : clip.layout)
    corner = {std::min(corner.x, place.x), std::min(corner.y, place.y)};
  if (clip.layout.empty()) corner = {};

  Edit edit{.label = countLabel("Paste", clip.nodes.size(), ids.begin()->second)};
  for (const auto& [id, node] : clip.nodes) {
    Node copy = node;
    for (auto input = copy.inputs.begin(); input != copy.inputs.end();) {
      if (auto& from = input->second.from) {
        if (const auto inside = ids.find(from->node); inside != ids.end())
          from->node = inside->second;
        else if (!material_.node(from->node))
          from.reset();
      }
      input = input->second.empty() ? copy.inputs.erase(input) : std::next(input);
    }
    // A pasted output would be a second one; its attributes live on as a node that makes them.
    if (copy.kind == "output" && !material_.outputNode().empty()) copy.kind = "set-attributes";
    const NodeId& to = ids[id];
    edit.nodes[to].after = std::move(copy);
    Position place = corner;
    if (const auto old = clip.layout.find(id); old != clip.layout.end()) place = old->second;
    edit.layout[to] = {placeOf(to), Position{at.x + place.x - corner.x, at.y + place.y - corner.y}};
    if (made) made->push_back(to);
  }
  return commit(std::move(edit));
}

Edit::Header GraphEditor::header() const {
  return {material_.kind, material_.name, material_.doc, material_.model, material_.modelParameters};
}

Diagnostics GraphEditor::changeHeader(Edit::Header after, std::string label) {
  Edit edit{.label = std::move(label)};
  edit.header = {header(), std::move(after)};
  return commit(std::move(edit));
}

Diagnostics GraphEditor::setModel(const std::string& id) {
  Edit::Header after = header();
  after.model = id;
  return changeHeader(std::move(after), "Shading model " + id);
}

Diagnostics GraphEditor::setModelParameter(const std::string& parameter, std::optional<Value> value) {
  Edit::Header after = header();
  if (value)
    after.modelParameters[parameter] = *value;
  else
    after.modelParameters.erase(parameter);
  return changeHeader(std::move(after), "Set " + parameter);
}

Diagnostics GraphEditor::setName(const std::string& to) {
  Edit::Header after = header();
  after.name = to;
  return changeHeader(std::move(after), "Rename the material");
}

Diagnostics GraphEditor::setDoc(const std::string& to) {
  Edit::Header after = header();
  after.doc = to;
  return changeHeader(std::move(after), "Describe the material");
}

Diagnostics GraphEditor::replaceAll(const Material& to, std::string label) {
  Edit edit{.label = std::move(label)};
  const auto difference = [](const auto& before, const auto& after, auto& changes) {
    for (const auto& [id, value] : before) {
      const auto at = after.find(id);
      if (at == after.end())
        changes[id].before = value;
      else if (!(at->second == value))
        changes[id] = {value, at->second};
    }
    for (const auto& [id, value] : after)
      if (!before.count(id)) changes[id].after = value;
  };
  difference(material_.nodes, to.nodes, edit.nodes);
  difference(material_.layout, to.layout, edit.layout);
  Edit::Header after{to.kind, to.name, to.doc, to.model, to.modelParameters};
  if (!(header() == after)) edit.header = {header(), std::move(after)};
  return commit(std::move(edit));
}

void GraphEditor::beginGesture(std::string label) {
  if (depth_++ == 0) gesture_ = Edit{.label = std::move(label)};
}

void GraphEditor::endGesture() {
  GLINT_CHECK(depth_ > 0, "endGesture() without beginGesture()");
  if (--depth_ > 0) return;
  Edit edit = std::exchange(gesture_, {});
  if (!edit.empty()) record(std::move(edit));
}

void GraphEditor::cancelGesture() {
  GLINT_CHECK(depth_ > 0, "cancelGesture() without beginGesture()");
  apply(gesture_, false);
  gesture_.nodes.clear();
  gesture_.layout.clear();
  gesture_.header.reset();
  endGesture();
}

Diagnostics GraphEditor::commit(Edit edit) {
  std::erase_if(edit.nodes, [](const auto& item) { return same(item.second); });
  std::erase_if(edit.layout, [](const auto& item) { return same(item.second); });
  if (edit.header && same(*edit.header)) edit.header.reset();
  if (edit.empty()) return {};
  apply(edit, true);
  if (depth_ > 0)
    chainEdit(gesture_, edit);
  else
    record(std::move(edit));
  return {};
}

void GraphEditor::apply(const Edit& edit, bool forward) {
  if (edit.empty()) return;
  applyChanges(material_.nodes, edit.nodes, forward);
  applyChanges(material_.layout, edit.layout, forward);
  if (edit.header) {
    const Edit::Header& to = forward ? *edit.header->after : *edit.header->before;
    material_.kind = to.kind;
    material_.name = to.name;
    material_.doc = to.doc;
    material_.model = to.model;
    material_.modelParameters = to.modelParameters;
  }
  material_.lines.reset();
  ++revision_;
  if (edit.changesMeaning()) ++meaningRevision_;
}

void GraphEditor::record(Edit edit) {
  history_.resize(position_);
  if (savedPosition_ && *savedPosition_ > position_) savedPosition_.reset();
  history_.push_back(std::move(edit));
  ++position_;
}

bool GraphEditor::undo() {
  if (!canUndo()) return false;
  apply(history_[--position_], false);
  return true;
}

bool GraphEditor::redo() {
  if (!canRedo()) return false;
  apply(history_[position_++], true);
  return true;
}

std::string GraphEditor::undoLabel() const { return canUndo() ? history_[position_ - 1].label : ""; }
std::string GraphEditor::redoLabel() const { return canRedo() ? history_[position_].label : ""; }

bool GraphEditor::modified() const {
  return !savedPosition_ || *savedPosition_ != position_ || (depth_ > 0 && !gesture_.empty());
}

void GraphEditor::rewriteNodes(const std::function<void(Node&)>& change) {
  GLINT_CHECK(depth_ == 0, "rewriteNodes() within a gesture");
  for (auto& [id, node] : material_.nodes) change(node);
  for (Edit& edit : history_)
    for (auto& [id, node] : edit.nodes) {
      if (node.before) change(*node.before);
      if (node.after) change(*node.after);
    }
  ++revision_;
  ++meaningRevision_;
}

void GraphEditor::markSaved(const std::filesystem::path& file) {
  if (!file.empty()) material_.file = file;
  savedPosition_ = position_;
}

}  // namespace glint
