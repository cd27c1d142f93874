// From a material's graph, a shading model and values given from outside to what the renderer draws.
#pragma once

#include <span>
#include <string>

#include "materials/function_library.h"
#include "materials/graph.h"
#include "materials/graph_compile.h"
#include "materials/model_registry.h"
#include "materials/node_registry.h"
#include "renderer/surface_material.h"

namespace glint {

// NAME=VALUE as typed: an attribute, a parameter of the model, or a parameter of the material.
struct Setting {
  std::string name, text;
  std::string from = {};  // the option that gave it; empty: what surfaceWith() is told
};

// What making a material needs beside the material.
struct MaterialSources {
  const NodeRegistry& nodes;
  const FunctionLibrary& functions;
  TextureCache& textures;
  CompileOptions compile = {};
};

// Compiles the material for `model` with the settings in force, and loads its textures. The model's parameters and the
// attributes come before the material's own parameters, where names are shared. Errors: the graph's; a
// name that is none of the three (with the nearest) and a value that does not fit or is out of range, at the setting's
// `from`, else at `place`. `problems` gets warnings, and errors of textures, which are drawn as missing.
Result<SurfaceMaterial> surfaceWith(const Material&, const ModelPtr& model, std::span<const Setting>,
                                    const std::string& place, const MaterialSources&, Diagnostics& problems);

// Whether a setting of that name means anything to the material with that model.
bool takesSetting(const Material&, const ShadingModel& model, const std::string& name);

}  // namespace glint
