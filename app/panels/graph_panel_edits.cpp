// What gestures and commands do to the graph.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/graph_panel.h"
#include "materials/graph_validate.h"
#include "materials/material_json.h"

namespace glint {

bool GraphPanel::accepts(const Pin& pin, std::optional<ValueType> from) {
  if (!from || pin.type.kind == PinType::Kind::Any) return true;
  if (pin.type.kind == PinType::Kind::Exact) return converts(*from, pin.type.type);
  return *from != ValueType::Texture && *from != ValueType::Attributes;
}

bool GraphPanel::gives(const Pin& output, const Pin& input) {
  if (output.type.kind == PinType::Kind::Exact) return accepts(input, output.type.type);
  if (output.type.kind == PinType::Kind::Any || input.type.kind == PinType::Kind::Any) return true;
  return input.type.kind == PinType::Kind::Numeric ||
         (input.type.type != ValueType::Texture && input.type.type != ValueType::Attributes);
}

void GraphPanel::dropWire(Editor& editor, ImVec2 mouse) {
  Document& document = editor.document();
  const GraphContext context = editor.graphContext();
  const auto target = wireFromOutput_ ? canvas_.inputAt(mouse) : canvas_.outputAt(mouse);
  if (target) {
    if (detached_ && *target == *detached_) return;
    const PinRef from = wireFromOutput_ ? wire_ : *target, to = wireFromOutput_ ? *target : wire_;
    const Diagnostics problems = connectionProblems(document.material(), context, from, to);
    if (!problems.empty()) return editor.refused(problems);
    editor.refused(document.edit("Connect " + to.text(), [&](GraphEditor& graph) {
      graph.beginGesture("Connect " + to.text());
      if (detached_) graph.disconnect(*detached_);
      Diagnostics refusal = graph.connect(from, to);
      graph.endGesture();
      return refusal;
    }));
    return;
  }
  if (canvas_.nodeAt(mouse) && !detached_) return;
  if (detached_) {
    if (!moved_) return;
    editor.refused(document.edit("Disconnect " + detached_->text(), [&](GraphEditor& graph) { return graph.disconnect(*detached_); }));
    return;
  }
  if (!moved_) return;
  // On empty ground: what could go there.
  menuAt_ = canvas_.toSheet(mouse);
  menuWire_ = wire_;
  menuWireFromOutput_ = wireFromOutput_;
  const auto type = types_.find(wire_);
  const std::optional<ValueType> carried = type == types_.end() ? std::nullopt : std::optional(type->second);
  const NodeShape* shape = canvas_.shape(wire_.node);
  const Pin* pin = shape && shape->pins ? (wireFromOutput_ ? shape->pins->output(wire_.pin) : shape->pins->input(wire_.pin)) : nullptr;
  const std::optional<Pin> input = !wireFromOutput_ && pin ? std::optional(*pin) : std::nullopt;
  menu_.open([&editor, carried, input](const NodeKind& kind) {
    Node node;
    node.kind = kind.id;
    const NodePinsPtr pins = pinsOf(node, editor.graphContext());
    if (input) return std::any_of(pins->outputs.begin(), pins->outputs.end(), [&](const Pin& p) { return gives(p, *input); });
    return std::any_of(pins->inputs.begin(), pins->inputs.end(), [&](const Pin& p) { return accepts(p, carried); });
  });
}

// A position near the wished one where a node of that size covers no other.
Position GraphPanel::freePlace(ImVec2 wished, ImVec2 size) const {
  constexpr float kGap = 16, kStep = 24;
  const auto covers = [&](ImVec2 at) {
    return std::any_of(canvas_.shapes().begin(), canvas_.shapes().end(), [&](const auto& item) {
      const NodeShape& other = item.second;
      return !other.comment && at.x < other.position.x + other.size.x + kGap && other.position.x < at.x + size.x + kGap &&
             at.y < other.position.y + other.size.y + kGap && other.position.y < at.y + size.y + kGap;
    });
  };
  // Rings around it, the nearest place of each first; downwards and to the left where two are as near.
  for (int ring = 0; ring < 64; ++ring) {
    std::optional<ImVec2> best;
    float nearest = FLT_MAX;
    for (int x = -ring; x <= ring; ++x)
      for (int y = -ring; y <= ring; ++y) {
        if (std::max(std::abs(x), std::abs(y)) != ring) continue;
        const ImVec2 at{wished.x + float(x) * kStep, wished.y + float(y) * kStep};
        const float distance = std::hypot(float(x), float(y)) + (x > 0 ? 0.2f : 0) + (y < 0 ? 0.1f : 0);
        if (distance >= nearest || covers(at)) continue;
        nearest = distance;
        best = at;
      }
    if (best) return {std::round(best->x), std::round(best->y)};
  }
  return {std::round(wished.x), std::round(wished.y)};
}

void GraphPanel::openMenu(Editor&, ImVec2 screen) {
  menuAt_ = canvas_.toSheet(screen);
  menuWire_.reset();
  menu_.open();
}

Diagnostics GraphPanel::connectFirst(Editor& editor, GraphEditor& graph, const NodeId& made) const {
  const Node* node = graph.material().node(made);
  const GraphContext context = editor.graphContext();
  const NodePinsPtr pins = pinsOf(*node, context, graph.material().file.parent_path());
  for (const Pin& pin : menuWireFromOutput_ ? pins->inputs : pins->outputs) {
    const PinRef here{made, pin.name};
    const PinRef from = menuWireFromOutput_ ? *menuWire_ : here, to = menuWireFromOutput_ ? here : *menuWire_;
    if (connectionProblems(graph.material(), context, from, to).empty()) return graph.connect(from, to);
  }
  return {};
}

void GraphPanel::addChosen(Editor& editor, const NodeKind& kind) {
  NodeId made;
  Node node;
  node.kind = kind.id;
  const ImVec2 size = canvas_.measure("", node, editor.document().material(), editor.graphContext()).size;
  const Position at = freePlace(menuAt_, size);
  editor.refused(editor.document().edit("Add " + kind.title, [&](GraphEditor& graph) {
    graph.beginGesture("Add " + kind.title);
    Diagnostics refusal = graph.addNode(kind.id, at, &made);
    if (refusal.empty() && menuWire_) refusal = connectFirst(editor, graph, made);
    if (refusal.empty()) graph.endGesture();
    else graph.cancelGesture();
    return refusal;
  }));
  if (!made.empty()) editor.selection() = {made};
  menuWire_.reset();
}

void GraphPanel::insertReroute(Editor& editor, const PinRef& end, ImVec2 screen) {
  Document& document = editor.document();
  const PinRef from = *document.material().node(end.node)->inputs.at(end.pin).from;
  const ImVec2 p = canvas_.toSheet(screen);
  NodeId made;
  editor.refused(document.edit("Reroute", [&](GraphEditor& graph) {
    graph.beginGesture("Reroute");
    Diagnostics refusal = graph.addNode("reroute", {std::round(p.x - 10), std::round(p.y - 10)}, &made);
    if (refusal.empty()) {
      const NodePinsPtr pins = pinsOf(*graph.material().node(made), editor.graphContext());
      if (!pins->inputs.empty() && !pins->outputs.empty()) {
        refusal = graph.connect(from, {made, pins->inputs[0].name});
        if (refusal.empty()) refusal = graph.connect({made, pins->outputs[0].name}, end);
      }
    }
    if (refusal.empty()) graph.endGesture();
    else graph.cancelGesture();
    return refusal;
  }));
  if (!made.empty()) editor.selection() = {made};
}

// A node without wires that is dropped on a wire goes in between.
void GraphPanel::insertOnWire(Editor& editor, const NodeId& id) {
  Document& document = editor.document();
  const Material& material = document.material();
  const Node* node = material.node(id);
  const NodeShape* shape = canvas_.shape(id);
  if (!node || !shape || shape->comment || !wiresFrom(material, id).empty()) return;
  for (const auto& [pin, input] : node->inputs)
    if (input.from) return;
  const ImVec2 center = canvas_.toScreen({shape->position.x + shape->size.x / 2, shape->position.y + shape->header / 2});
  const auto end = canvas_.wireAt(center, material);
  if (!end || end->node == id) return;
  const PinRef from = *material.node(end->node)->inputs.at(end->pin).from;
  const GraphContext context = editor.graphContext();
  for (const Pin& in : shape->pins->inputs)
    for (const Pin& out : shape->pins->outputs) {
      if (!connectionProblems(material, context, from, {id, in.name}).empty()) continue;
      if (!connectionProblems(material, context, {id, out.name}, *end).empty()) continue;
      editor.refused(document.edit("Insert node", [&](GraphEditor& graph) {
        graph.beginGesture("Insert node");
        Diagnostics refusal = graph.connect(from, {id, in.name});
        if (refusal.empty()) refusal = graph.connect({id, out.name}, *end);
        if (refusal.empty()) graph.endGesture();
        else graph.cancelGesture();
        return refusal;
      }));
      return;
    }
}

void GraphPanel::remove(Editor& editor) {
  auto& selection = editor.selection();
  if (selection.empty()) return;
  const std::set<NodeId> gone = selection;
  const Diagnostics refusal =
      editor.document().edit(gone.size() == 1 ? "Delete node" : "Delete " + std::to_string(gone.size()) + " nodes",
                             [&](GraphEditor& graph) { return graph.removeNodes(gone); });
  editor.refused(refusal);
  if (refusal.empty()) selection.clear();
}

void GraphPanel::copy(Editor& editor) {
  if (!editor.selection().empty())
    ImGui::SetClipboardText(clipText(copyNodes(editor.document().material(), editor.selection())).c_str());
}

void GraphPanel::paste(Editor& editor, const Clip& clip, ImVec2 sheet) {
  std::vector<NodeId> made;
  editor.refused(editor.document().edit("Paste", [&](GraphEditor& graph) {
    return graph.paste(clip, {std::round(sheet.x), std::round(sheet.y)}, &made);
  }));
  if (!made.empty()) editor.selection() = {made.begin(), made.end()};
}

void GraphPanel::comment(Editor& editor) {
  ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  for (const NodeId& id : editor.selection())
    if (const NodeShape* shape = canvas_.shape(id)) {
      low = {std::min(low.x, shape->position.x), std::min(low.y, shape->position.y)};
      high = {std::max(high.x, shape->position.x + shape->size.x), std::max(high.y, shape->position.y + shape->size.y)};
    }
  if (low.x > high.x) {
    low = canvas_.toSheet(ImGui::GetIO().MousePos);
    high = {low.x + 260, low.y + 140};
  }
  Node node;
  node.kind = "comment";
  node.settings["text"] = Json::of("Comment");
  node.settings["width"] = Json::of(std::round(high.x - low.x + 40));
  node.settings["height"] = Json::of(std::round(high.y - low.y + 64));
  NodeId made;
  editor.refused(editor.document().edit("Add comment", [&](GraphEditor& graph) {
    return graph.addNode(node, {std::round(low.x - 20), std::round(low.y - 44)}, "comment", &made);
  }));
  if (!made.empty()) editor.selection() = {made};
}

}  // namespace glint
