// Whether OpenGL is drawn by the processor.
#pragma once

#include <string>

namespace glint::gl {

// By the renderer's name, GL_RENDERER.
bool isSoftware(const std::string& renderer);

}  // namespace glint::gl
