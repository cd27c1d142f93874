// One material, function or layer as a JSON file: versioned, deterministic, one line for each thing that can
// change on its own, node positions in a section of their own.
//
//   { "glint": "material", "version": 1, "name": "aluminium", "doc": "...", "model": "ggx",
//     "modelParameters": {"gamma": 1.5},
//     "nodes": {
//       "dirt":   {"kind": "noise", "inputs": {"scale": 8}},
//       "output": {"kind": "output", "inputs": {"metallic": 1, "roughness": "dirt.value"}},
//       "tint":   {"kind": "parameter", "name": "Tint", "type": "color", "value": [0.9, 0.9, 0.9]}
//     },
//     "layout": {"dirt": [-240, 0], "output": [0, 0]} }
//
// An input is a constant (number, array, true or false, "#rrggbb"), a wire ("node.pin"), or both
// ({"from": "node.pin", "value": 1}). The other members of a node are its settings.
#pragma once

#include <filesystem>
#include <string>

#include "materials/graph.h"
#include "materials/graph_edit.h"
#include "materials/node_registry.h"

namespace glint {

inline constexpr int kMaterialVersion = 1;
inline constexpr size_t kMostNodes = 20000;       // of one document
inline constexpr size_t kLargestMaterialFile = size_t{16} << 20;

// Errors: not JSON, a member of the wrong type, an id that is none, over a limit, a version that this program
// does not know. Warnings, through `warnings`: unknown members and settings, with the nearest known
// name; they are kept, and written back as they were. What the graph means is judged by graph_validate.h.
Result<Material> parseMaterial(const std::string& text, const std::filesystem::path& file,
                               const NodeRegistry&, Diagnostics* warnings = nullptr);
std::string materialText(const Material&);

Result<Material> readMaterial(const std::filesystem::path& file, const NodeRegistry&,
                              Diagnostics* warnings = nullptr);
// Atomic; on success the material's file is `file`.
Diagnostics writeMaterial(const std::filesystem::path& file, Material&);

// A clipboard's text: a document of kind "clip".
std::string clipText(const Clip&);
Result<Clip> parseClip(const std::string& text, const NodeRegistry&);

}  // namespace glint
