#include "renderer/gl/context.h"

#include <array>
#include <atomic>
#include <cstring>

#include "materials/base/log.h"
#include "renderer/gl/context_backends.h"
#include "renderer/gl/software.h"
#include "renderer/gl/gl.h"

namespace glint::gl {
namespace {

constexpr std::array<std::pair<Backend, std::string_view>, 4> kNames{{{Backend::Auto, "auto"},
                                                                     {Backend::Glfw, "glfw"},
                                                                     {Backend::Egl, "egl"},
                                                                     {Backend::OsMesa, "osmesa"}}};
std::atomic<int> errors{0};

void GLAD_API_PTR onDebugMessage(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei,
                                 const GLchar* message, const void*) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  // What a broken plugin gets from the compiler; it is reported with its place elsewhere.
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  ++errors;
  log::report(error("OpenGL", message, "this is a fault of Glint: please report it"));
}

}  // namespace

std::string_view name(Backend wanted) {
  for (const auto& [backend, text] : kNames)
    if (backend == wanted) return text;
  return "?";
}

std::optional<Backend> backend(std::string_view wanted) {
  for (const auto& [backend, text] : kNames)
    if (text == wanted) return backend;
  return std::nullopt;
}

int errorCount() { return errors; }

Result<std::unique_ptr<Context>> Context::create(const ContextRequest& request) {
  switch (request.backend) {
    case Backend::Glfw: return createGlfwContext(request);
    case Backend::Egl: return createEglContext();
    case Backend::OsMesa: return createOsMesaContext();
    case Backend::Auto: break;
  }
  if (request.window) return createGlfwContext(request);
  auto egl = createEglContext();
  if (egl) return egl;
  auto osmesa = createOsMesaContext();
  if (osmesa) return osmesa;
  Diagnostics all = egl.diagnostics();
  all.insert(all.end(), osmesa.diagnostics().begin(), osmesa.diagnostics().end());
  return all;
}

void Context::loadFunctions(void* (*getProcAddress)(const char*)) {
  GLINT_CHECK(gladLoadGL(reinterpret_cast<GLADloadfunc>(getProcAddress)) != 0);
  const auto text = [](GLenum what) {
    const GLubyte* s = glGetString(what);
    return std::string(s ? reinterpret_cast<const char*>(s) : "");
  };
  info_.vendor = text(GL_VENDOR);
  info_.renderer = text(GL_RENDERER);
  info_.version = text(GL_VERSION);
  info_.glsl = text(GL_SHADING_LANGUAGE_VERSION);
  info_.software = isSoftware(info_.renderer);
  functionsLoaded_ = true;
  setStandardState();
}

void Context::setStandardState() {
  // Who loads the functions comes here before it has them.
  if (standardState_ || !functionsLoaded_) return;
  standardState_ = true;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(onDebugMessage, nullptr);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

}  // namespace glint::gl
