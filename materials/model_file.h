// The kinds of files that a shading model can be: a plugin of Glint's (model.h), or one of BRDF Explorer's (brdf_file.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "materials/model.h"

namespace glint {

// By its extension: .glsl, .brdf or .bparam.
bool isModelFile(const std::filesystem::path&);
const std::vector<std::string>& modelFileExtensions();

// Reads a model of any kind from the text of its file. Warnings are beside a model that can be used.
Result<ShadingModel> readModel(const std::filesystem::path&, const std::string& text, Diagnostics& warnings);
// The same from the file itself.
Result<ShadingModel> readModelFile(const std::filesystem::path&, Diagnostics& warnings);

// The file that a model's file names and that its model is made of too; empty where there is none.
std::filesystem::path fileBehind(const std::filesystem::path&, const std::string& text);

inline constexpr uintmax_t kLargestModelFile = 1 << 20;

}  // namespace glint
