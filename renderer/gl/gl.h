// The OpenGL functions (glad, generated at build time). Only renderer/ and the editor's ImGui back end use
// them.
#pragma once

#include <glad/gl.h>
