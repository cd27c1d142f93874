// The editor in a window.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor.h"

namespace glint {

// Runs until the user leaves. `files` are opened in order. Returns an exit code.
int runWindow(gl::Context&, EditorOptions, const std::vector<std::filesystem::path>& files);

}  // namespace glint
