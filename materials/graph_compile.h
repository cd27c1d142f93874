// Graph to GLSL: functions and layers inlined, attribute bundles taken apart, what cannot be seen pruned,
// equal expressions shared, constants folded.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "materials/compiled_material.h"
#include "materials/function_library.h"
#include "materials/graph.h"
#include "materials/model.h"
#include "materials/node_registry.h"

namespace glint {

struct CompileOptions {
  // Constants on pins become uniforms too, as far as the block has room, so that dragging any value in an
  // editor changes the block and not the program. Off, they are folded into the text.
  bool valuesAsUniforms = false;
  // Files outside the material's folder that the user named, which its textures may thus be.
  std::set<std::filesystem::path> namedFiles;
};

// All errors of validate(), or the material compiled for `model` (whatever material.model says). Warnings go
// to `warnings`. The same graph gives the same text; values of parameters are never part of it.
Result<CompiledMaterial> compileMaterial(const Material&, const ShadingModel& model, const NodeRegistry&,
                                         const FunctionLibrary&, const CompileOptions& = {},
                                         Diagnostics* warnings = nullptr);

// The value that a text gives an attribute or a parameter of the model. Errors: a name that is neither (with the
// nearest), a value that does not fit or is out of range.
Result<Value> overrideValue(const ShadingModel& model, const std::string& name, std::string_view valueText);

// Makes one attribute or parameter of the model come from outside (`--set roughness=0.3`, a sweep), whatever
// the graph says: a parameter node of that name is put before the output, so that all values share one
// program; later calls with the same name change its value. For a model parameter without a pin, sets
// Material::modelParameters. Errors: as overrideValue().
Diagnostics overrideAttribute(Material&, const ShadingModel& model, const std::string& name,
                              std::string_view valueText);

}  // namespace glint
