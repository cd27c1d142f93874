// The material's graph, to be wired by hand.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "app/editor/editor.h"
#include "app/editor/node_canvas.h"
#include "app/editor/node_menu.h"
#include "app/panels/panel.h"

namespace glint {

class GraphPanel final : public Panel {
 public:
  void draw(Editor&) override;

 private:
  enum class Mode { None, Pan, Box, Move, Wire, Knife, Value, Resize };

  // graph_panel.cpp: the frame, gestures and keys
  void toolbar(Editor&);
  void refresh(Editor&);
  void control(Editor&, bool hovered);
  void press(Editor&, ImVec2 mouse);
  void release(Editor&, ImVec2 mouse);
  void keys(Editor&);
  void frame(const std::set<NodeId>& only = {});
  void frameOutput(const Material&);                            // readable, however large the graph is
  std::optional<PinRef> fieldAt(Editor&, ImVec2 screen) const;  // the input whose value is shown there

  // graph_panel_edits.cpp: what they do to the graph
  void dropWire(Editor&, ImVec2 mouse);
  Position freePlace(ImVec2 wished, ImVec2 size) const;
  // Whether a value of that type, or what an output gives, could go into the pin, as far as the pins alone tell.
  static bool accepts(const Pin&, std::optional<ValueType> from);
  static bool gives(const Pin& output, const Pin& input);
  void addChosen(Editor&, const NodeKind&);
  void openMenu(Editor&, ImVec2 screen);
  void insertReroute(Editor&, const PinRef& wireEnd, ImVec2 screen);
  void insertOnWire(Editor&, const NodeId&);
  void remove(Editor&);
  void copy(Editor&);
  void paste(Editor&, const Clip&, ImVec2 sheet);
  void comment(Editor&);
  Diagnostics connectFirst(Editor&, GraphEditor&, const NodeId&) const;

  // graph_panel_drawing.cpp: how it looks
  void drawWires(Editor&);
  void drawWiresBehindNodes(Editor&);
  bool fitsDraggedWire(const PinRef&, const Pin&, bool output) const;
  void drawNode(Editor&, const NodeId&, const Node&, const NodeShape&);
  void drawComment(Editor&, const NodeId&, const NodeShape&);
  void drawField(const Node&, const Pin&, ImVec2 low, ImVec2 high) const;
  void drawWireBeingDragged(Editor&);
  ImU32 pinColor(const PinRef&, const Pin&, bool output) const;
  bool fieldRect(const NodeShape&, size_t input, ImVec2& low, ImVec2& high) const;
  void valuePopup(Editor&);

  NodeCanvas canvas_;
  NodeMenu menu_;
  uint64_t laidOut_ = 0, typed_ = 0;
  const void* model_ = nullptr;
  float scale_ = 0;
  std::map<PinRef, ValueType> types_;
  std::map<NodeId, std::string> errors_;
  std::map<NodeId, Position> fallback_;
  uint64_t framed_ = 0;               // Document::identity()

  Mode mode_ = Mode::None;
  ImVec2 pressed_{}, last_{};
  bool moved_ = false, fromRight_ = false;
  std::map<NodeId, Position> moveStart_;
  std::set<NodeId> boxStart_;
  PinRef wire_;                       // where the wire being dragged starts
  bool wireFromOutput_ = true;
  std::optional<PinRef> detached_;    // the input that it was taken from
  PinRef value_;                      // the input whose value is being dragged
  float valueStart_ = 0;
  PinRef popupPin_;
  std::string popupWanted_;
  std::vector<ImVec2> knife_;
  ImVec2 resizeStart_{};
  NodeId resized_;
  ImVec2 menuAt_{};                   // on the sheet
  std::optional<PinRef> menuWire_;    // to be connected to what is added
  bool menuWireFromOutput_ = true;
  bool frameWanted_ = true, first_ = true;   // first_: as a material just opened is shown
};

}  // namespace glint
