// Graphs for tests, and the registries that all of them share.
#pragma once

#include <string>

#include "materials/function_library.h"
#include "materials/graph.h"
#include "materials/graph_compile.h"
#include "materials/model.h"
#include "materials/node_registry.h"

namespace glint::test {

const NodeRegistry& nodes();
FunctionLibrary& functions();
const ShadingModel& ggx();            // no parameters
const ShadingModel& withParameters(); // "gamma" (slot 0), "tint" (colour, slot 1) and "quality" (no slot)

std::string texts(const Diagnostics&);  // one a line

Result<CompiledMaterial> compile(const Material&, const ShadingModel& = ggx());

// A material that shows every output of one node, whose numeric inputs have that type.
Material materialOf(const NodeKind&, ValueType numeric);

// `count` nodes: a grid of arithmetic and patterns that all count towards the output.
Material bigMaterial(int count);

void wire(Material&, const std::string& from, const std::string& to);  // "a.value", "b.x"
Node& add(Material&, const std::string& id, const std::string& kind);

}  // namespace glint::test
