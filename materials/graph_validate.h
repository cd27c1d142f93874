// Whether a graph means something: every fault at once, each at its node and pin.
#pragma once

#include "materials/graph.h"
#include "materials/node.h"

namespace glint {

// Errors: unknown kinds that a result depends on, wires from nowhere, cycles, types that do not fit, constants of the wrong type, no
// output or several, functions that cannot be found or call themselves. Warnings: unknown kinds that nothing uses, pins that the node does not
// have now (they may belong to another shading model; their wires are kept), unknown model parameters,
// values outside a setting's range. Errors of nodes that reach no output count too: the file should mend.
Diagnostics validate(const Material&, const GraphContext&);

// Why a wire between these pins is not possible, for the person who drags it; nothing when it is. A wire that
// is already at `to` does not count.
Diagnostics connectionProblems(const Material&, const GraphContext&, const PinRef& from, const PinRef& to);

// The nodes in an order where each comes after those it is fed by; of equals, by id. Nodes on or behind a cycle
// are left out; one cycle, as the nodes along it, goes to `cycle`.
std::vector<NodeId> topologicalOrder(const Material&, std::vector<NodeId>* cycle = nullptr);

// What type each output pin carries, numeric and any pins resolved. Pins whose type cannot be known (behind
// an error) are absent. For the colours of wires.
std::map<PinRef, ValueType> outputTypes(const Material&, const GraphContext&);

}  // namespace glint
