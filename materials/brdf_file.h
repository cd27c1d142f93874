// BRDF Explorer's files as shading models, as they are. Its grammar, line by line (# is a comment on every line that
// starts so, also among the GLSL):
//
//   analytic                                  the first line
//   ::begin parameters
//   float NAME MIN MAX DEFAULT | bool NAME 0-or-1 | color NAME R G B        color as the GLSL gets it: linear
//   ::end parameters
//   ::begin shader
//   GLSL 4.10 with  vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)       f without cosine; unit vectors
//   ::end shader
//
// Other sections are left alone. A .bparam has `bparam PATH` in its first line and values for that file's parameters.
//
// The model's id is the file's name. The GLSL is in a namespace of its own, as one specular part: it reads no attribute
// but the normal, and claims nothing. A parameter that is named as an attribute (roughness) is called ownRoughness where
// the two could meet.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "materials/model.h"

namespace glint {

// `file` is for messages and the id. Errors, each at its line and all at once: what BRDF Explorer refuses, and what it
// lets through: a section that is not closed, missing values, an empty range, a default outside of it, names that GLSL
// or BRDF Explorer keep for themselves. Warnings: sections that nobody knows, text outside of sections.
Result<ShadingModel> parseBrdf(const std::filesystem::path& file, const std::string& text, Diagnostics& warnings);

// Reads the .brdf that it names too. Parameters that this one does not have are warnings.
Result<ShadingModel> parseBparam(const std::filesystem::path& file, const std::string& text, Diagnostics& warnings);

// The file that a .bparam names. It is looked for in the folder of the .bparam and below; an absolute path, which is
// what BRDF Explorer writes, stands for the file of that name beside the .bparam. Errors: leaves the folder, no .brdf.
Result<std::filesystem::path> fileOfBparam(const std::filesystem::path& bparam, const std::string& text);

// The id for a model whose file says none: the file's name, its letters that no id may have replaced.
std::string modelIdOfFile(const std::filesystem::path&);

}  // namespace glint
