// Every change to a material, as an invertible command in one log. An edit is stored as what it changed,
// before and after, so undoing is exact whatever the edit was.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "materials/graph.h"
#include "materials/node.h"

namespace glint {

// A part of a graph on its way through the clipboard (as text: clipText() in material_json.h).
struct Clip {
  std::map<NodeId, Node> nodes;
  std::map<NodeId, Position> layout;
};
// Wires from nodes that are not copied stay, so that a paste into the same material keeps them.
Clip copyNodes(const Material&, const std::set<NodeId>&);

// One step of undo.
struct Edit {
  template <class T>
  struct Change {
    std::optional<T> before, after;  // absent: did not exist
  };
  // All that a material has beside its nodes and their places.
  struct Header {
    DocumentKind kind;
    std::string name, doc, model;
    std::map<std::string, Value> modelParameters;
    bool operator==(const Header&) const = default;
  };

  std::string label;  // "Connect", "Move 3 nodes": for the menu
  std::map<NodeId, Change<Node>> nodes;
  std::map<NodeId, Change<Position>> layout;
  std::optional<Change<Header>> header;

  bool empty() const { return nodes.empty() && layout.empty() && !header; }
  bool changesMeaning() const { return !nodes.empty() || header; }
};

// Owns a material and its history. Every function that edits gives the diagnostics that made it refuse, in
// which case nothing changed, or nothing.
class GraphEditor {
 public:
  explicit GraphEditor(Material material = newMaterial("material"));

  const Material& material() const { return material_; }

  Diagnostics addNode(std::string_view kind, Position, NodeId* made = nullptr);
  Diagnostics addNode(Node, Position, std::string_view wishedId, NodeId* made = nullptr);
  // With every wire that starts or ends at them. The last output node stays.
  Diagnostics removeNodes(const std::set<NodeId>&);
  // Replaces the wire that ends there. Refuses unknown nodes and wires that would close a cycle; whether the
  // types fit is connectionProblems() of graph_validate.h.
  Diagnostics connect(const PinRef& from, const PinRef& to);
  Diagnostics disconnect(const PinRef& to);
  Diagnostics setValue(const PinRef& input, const Value&);
  Diagnostics resetValue(const PinRef& input);  // back to the pin's default
  Diagnostics setSetting(const NodeId&, const std::string& key, const Json&);
  Diagnostics resetSetting(const NodeId&, const std::string& key);
  Diagnostics move(const std::map<NodeId, Position>&);
  // Changes the id, everywhere.
  Diagnostics rename(const NodeId& from, const NodeId& to);
  // Another kind in its place; keeps the wires and constants of inputs with the same name, else of the same
  // position, and likewise the wires from outputs.
  Diagnostics replaceNode(const NodeId&, std::string_view kind, const GraphContext&);
  // The clip's nodes under free ids, their wires among themselves kept, moved so that the top left of them
  // lies at `at`. `made` gets the new ids in the order of the old.
  Diagnostics paste(const Clip&, Position at, std::vector<NodeId>* made = nullptr);
  Diagnostics setModel(const std::string& id);
  Diagnostics setModelParameter(const std::string& name, std::optional<Value>);
  Diagnostics setName(const std::string&);
  Diagnostics setDoc(const std::string&);
  // The whole document becomes another, as one step (import, revert to the file on disk).
  Diagnostics replaceAll(const Material&, std::string label);

  // Everything between the two is one step: a drag, or several edits that belong together. Gestures nest;
  // the outermost counts. One that changed nothing in the end leaves no step. cancelGesture() puts back what
  // it changed.
  void beginGesture(std::string label);
  void endGesture();
  void cancelGesture();
  bool inGesture() const { return depth_ > 0; }

  bool canUndo() const { return depth_ == 0 && position_ > 0; }
  bool canRedo() const { return depth_ == 0 && position_ < history_.size(); }
  bool undo();  // false when there is nothing to undo
  bool redo();
  std::string undoLabel() const;  // "" when there is nothing
  std::string redoLabel() const;
  const std::vector<Edit>& history() const { return history_; }
  size_t position() const { return position_; }  // how many of the history are in force

  // Grow with every change, undo and redo; the second only when the meaning changed, not the layout.
  uint64_t revision() const { return revision_; }
  uint64_t meaningRevision() const { return meaningRevision_; }
  // Whether the material differs from when markSaved() was last called, or from the start.
  bool modified() const;
  // Changes nodes in every state that undo and redo reach, without a step: where their files lie, after these moved.
  void rewriteNodes(const std::function<void(Node&)>&);
  void markSaved(const std::filesystem::path& file = {});

 private:
  Diagnostics commit(Edit);
  void apply(const Edit&, bool forward);
  void record(Edit);
  Diagnostics refuse(std::string_view node, std::string_view pin, std::string what, std::string hint = {});
  Diagnostics missing(const NodeId&);
  Diagnostics changeNode(const NodeId&, std::string label, Node after);
  std::optional<Position> placeOf(const NodeId&) const;
  Edit::Header header() const;
  Diagnostics changeHeader(Edit::Header, std::string label);

  Material material_;
  std::vector<Edit> history_;
  size_t position_ = 0;
  std::optional<size_t> savedPosition_ = 0;  // nothing when the saved state can no longer be reached
  Edit gesture_;
  int depth_ = 0;
  uint64_t revision_ = 1, meaningRevision_ = 1;
};

}  // namespace glint
