// The files that Glint ships: GLSL, materials, fonts.
//
// A file is named by its path from the project's root ("shaders/models/ggx.glsl",
// "fonts/Inter-Regular.otf"). It is read from the folder $GLINT_DATA_DIR when that is set, else from
// the source tree this binary was built in when that is still there (so an edit shows without a
// build), else from the copy embedded in the binary.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::shipped {

// The contents of a shipped file, or nothing when there is no such file.
std::optional<std::string> read(std::string_view path);

// The paths of the shipped files directly in `folder` ("shaders/models") that end in `extension`
// (".glsl"), sorted.
std::vector<std::string> list(std::string_view folder, std::string_view extension);

// Where a shipped path lies on disk, or an empty path when only the embedded copy exists.
std::filesystem::path onDisk(std::string_view path);

}  // namespace glint::shipped
