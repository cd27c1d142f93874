// The sheet that nodes lie on: its view, where each part of a node lies, and how nodes and wires are drawn. Knows ids,
// pins and titles; what they mean and what a gesture does is the graph panel's.
#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/fonts.h"
#include "materials/graph.h"
#include "materials/node.h"

namespace glint {

// Where a node's parts lie, in sheet units.
struct NodeShape {
  ImVec2 position{}, size{};
  std::string title;
  bool reroute = false, comment = false, unknown = false;
  NodePinsPtr pins;
  float header = 0, row = 0;
  // Centres of pins; in the order of `pins`.
  std::vector<ImVec2> inputs, outputs;
};

class NodeCanvas {
 public:
  // Between screen and sheet.
  ImVec2 toScreen(ImVec2 sheet) const;
  ImVec2 toSheet(ImVec2 screen) const;
  float unit() const;                          // framebuffer pixels a sheet unit
  float zoom() const;

  void begin(ImVec2 low, ImVec2 high, Fonts&); // the panel's inside, each frame
  ImVec2 low() const { return low_; }
  ImVec2 high() const { return high_; }
  void pan(ImVec2 screenDelta);
  void zoomAt(ImVec2 screen, int steps);       // to the next of the zooms at which text is sharp
  void show(ImVec2 low, ImVec2 high);          // frames a part of the sheet
  // The same, but never smaller than text can be read at: what does not fit is a drag away, `focus` is seen.
  void showReadable(ImVec2 low, ImVec2 high, ImVec2 focus);
  void reveal(ImVec2 low, ImVec2 high);        // pans as little as brings a part of the sheet into view
  bool placed() const { return placed_; }

  // Size and pins of a node, which need not be in the material.
  NodeShape measure(const NodeId&, const Node&, const Material&, const GraphContext&) const;
  // Measures every node anew; call when the graph, its model or the fonts changed.
  void layOut(const Material&, const GraphContext&);
  const std::map<NodeId, NodeShape>& shapes() const { return shapes_; }
  void place(const std::map<NodeId, Position>&);  // where the material says nothing
  const NodeShape* shape(const NodeId&) const;
  std::optional<ImVec2> pinCenter(const PinRef&, bool output) const;  // on the sheet
  // What lies under a point of the screen, topmost first. `order` is drawn last to first.
  std::optional<NodeId> nodeAt(ImVec2 screen) const;
  std::optional<PinRef> inputAt(ImVec2 screen) const;
  std::optional<PinRef> outputAt(ImVec2 screen) const;
  // The input whose wire passes within a few pixels.
  std::optional<PinRef> wireAt(ImVec2 screen, const Material&) const;
  std::vector<PinRef> wiresCrossing(ImVec2 a, ImVec2 b, const Material&) const;
  void raise(const NodeId&);                   // draws it last
  const std::vector<NodeId>& order() const { return order_; }

  // Drawing, into the current window.
  void drawGrid() const;
  void drawWire(ImVec2 fromScreen, ImVec2 toScreen, ImU32 from, ImU32 to, bool strong) const;
  // Draws the parts of a wire that lie behind nodes, other than the two it belongs to, over these as a broken line.
  void drawWireBehindNodes(ImVec2 fromScreen, ImVec2 toScreen, ImU32 color, const NodeId& source, const NodeId& target) const;
  ImFont* face() const { return faces_.regular; }
  ImFont* boldFace() const { return faces_.bold; }
  void text(ImVec2 screen, ImU32 color, const std::string&, bool bold = false, float room = 1e9f) const;
  float textWidth(const std::string&, bool bold = false) const;  // in framebuffer pixels at this zoom

 private:
  static void placePins(NodeShape&);

  ImVec2 low_{}, high_{}, origin_{};           // sheet point at the middle of the panel
  int zoomIndex_ = 4;
  bool placed_ = false;
  Fonts::CanvasFaces faces_{};
  Fonts* fonts_ = nullptr;
  std::map<NodeId, NodeShape> shapes_;
  std::vector<NodeId> order_;
};

// Positions for nodes that have none, or for all: columns from the output to the left by distance, evenly spaced.
std::map<NodeId, Position> tidyPositions(const Material&, const NodeCanvas&);

}  // namespace glint
