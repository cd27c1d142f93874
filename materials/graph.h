// A material as values: nodes, their wires and constants, and, apart from that meaning, where the nodes lie
// on the canvas. Plain data: change it through materials/graph_edit.h, so that every change can be undone.
#pragma once

#include <array>
#include <compare>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/json.h"
#include "materials/value.h"

namespace glint {

// A node's name within its graph: letters, digits, '-' and '_', at most kLongestNodeId. It is what wires,
// diagnostics and the generated GLSL call the node; it stays the same until someone renames it.
using NodeId = std::string;
inline constexpr size_t kLongestNodeId = 64;
bool validNodeId(std::string_view);

// An output pin, as the source of a wire; or an input pin, as its end.
struct PinRef {
  NodeId node;
  std::string pin;
  auto operator<=>(const PinRef&) const = default;
  std::string text() const { return node + "." + pin; }  // as files spell it
};

// What feeds one input pin. A wire wins over the constant, which stays beneath it.
struct Input {
  std::optional<PinRef> from;
  std::optional<Value> value;  // absent: the pin's default
  bool operator==(const Input&) const = default;
  bool empty() const { return !from && !value; }
};

struct Node {
  std::string kind;                      // id of a NodeKind (materials/node.h); may be unknown here
  std::map<std::string, Input> inputs;   // by pin, only those that are wired or have a constant
  std::map<std::string, Json> settings;  // what is chosen in the node ("file", "function", "type", ...),
                                         // and whatever else the file said of it
  bool operator==(const Node&) const = default;
};

// Of a node's top left corner on the canvas, in units of an unscaled pixel, x to the right, y down.
struct Position {
  float x = 0, y = 0;
  bool operator==(const Position&) const = default;
};

// Material: has one node of kind "output". Function: takes its inputs from "function-input" nodes and gives
// its results in "function-output" nodes. Layer: a function whose one result is MaterialAttributes.
enum class DocumentKind { Material, Function, Layer };
std::string_view name(DocumentKind);  // "material", "function", "layer"
std::optional<DocumentKind> documentKind(std::string_view name);

// Which line of its file each node and pin came from. Dropped at the first edit.
struct SourceLines {
  int model = 0;
  std::map<NodeId, int> nodes;
  std::map<PinRef, int> pins;
};

struct Material {
  DocumentKind kind = DocumentKind::Material;
  std::string name;                 // one word; "painted-metal"
  std::string doc;                  // one sentence
  std::string model = "ggx";        // id of the shading model it asks for
  // Of the model, for the whole material. They are what the parameters' pins start from, and the only way to
  // set those that have no pin (ModelParameter::slot < 0). A number is a Float, an array a vector.
  std::map<std::string, Value> modelParameters;
  std::map<NodeId, Node> nodes;
  std::map<NodeId, Position> layout;
  std::map<std::string, Json> extra;  // keys of the file that this version does not know, kept

  // Not part of the meaning.
  std::filesystem::path file;       // where it was read from; empty for a new one
  std::shared_ptr<const SourceLines> lines;

  bool operator==(const Material& other) const;  // all but `file` and `lines`

  const Node* node(std::string_view id) const;
  NodeId outputNode() const;        // the first of kind "output", or ""
  // Where a node, or one of its pins, is: "FILE:LINE: node 'n' pin 'p'".
  std::string place(std::string_view node = {}, std::string_view pin = {}) const;
  std::string modelPlace() const;   // "FILE:LINE" of the model that it asks for
};

// A material with an output node and nothing else.
Material newMaterial(std::string name, std::string model = "ggx");

// A node id that is free in the material: `wish` made valid, with a number appended when it is taken.
NodeId freeNodeId(const Material&, std::string_view wish);

// The ends of every wire that starts at the node (at any pin when `pin` is empty), sorted.
std::vector<PinRef> wiresFrom(const Material&, std::string_view node, std::string_view pin = {});

// Settings, read with their fallback when absent or of another type.
std::string settingText(const Node&, std::string_view key, std::string_view fallback = {});
float settingNumber(const Node&, std::string_view key, float fallback);
bool settingBool(const Node&, std::string_view key, bool fallback);

}  // namespace glint
