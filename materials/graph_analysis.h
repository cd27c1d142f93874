// What the validator and the compiler both need to know of one document: its order, its pins and its types.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "materials/graph.h"
#include "materials/node.h"

namespace glint {

struct NodeInfo {
  const Node* node = nullptr;
  const NodeKind* kind = nullptr;   // null: unknown
  NodePinsPtr pins;
  // What "numeric" pins (or "any" ones) are in this node; nothing when that is not known, behind an error.
  std::optional<ValueType> generic;
};

struct GraphAnalysis {
  std::vector<NodeId> order;        // see topologicalOrder()
  std::map<NodeId, NodeInfo> nodes; // all, also those of a cycle
  std::map<PinRef, ValueType> outputs;
  Diagnostics problems;             // of this document alone
};

GraphAnalysis analyse(const Material&, const GraphContext&);

// A constant as another type: a number fills vectors and is an int when whole, vec3 and color are one.
std::optional<Value> coerced(const Value&, ValueType);

// A setting of type Value, read with the type that the node chose; nothing when it does not fit.
std::optional<Value> settingValue(const Node&, std::string_view key, ValueType);

}  // namespace glint
