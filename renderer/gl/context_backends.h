// The three ways to a context. Each is one file; context.cpp chooses.
#pragma once

#include "renderer/gl/context.h"

namespace glint::gl {

Result<std::unique_ptr<Context>> createGlfwContext(const ContextRequest&);
Result<std::unique_ptr<Context>> createEglContext();
Result<std::unique_ptr<Context>> createOsMesaContext();

}  // namespace glint::gl
