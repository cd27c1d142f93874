// A window, or an invisible one for a worker thread.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "renderer/gl/context_backends.h"

namespace glint::gl {
namespace {

std::string lastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

class GlfwBackend final : public Context {
 public:
  GlfwBackend(GLFWwindow* window, bool owner) : window_(window), owner_(owner) {}
  ~GlfwBackend() override {
    glfwDestroyWindow(window_);
    if (owner_) glfwTerminate();
  }
  Backend backend() const override { return Backend::Glfw; }
  void makeCurrent() override {
    glfwMakeContextCurrent(window_);
    setStandardState();
  }
  void release() override { glfwMakeContextCurrent(nullptr); }
  GLFWwindow* window() const override { return window_; }
  Result<std::unique_ptr<Context>> createShared() override {
    return make({.window = false, .width = 16, .height = 16}, this);
  }

  static Result<std::unique_ptr<Context>> make(const ContextRequest& request, const GlfwBackend* share) {
    if (!share && !glfwInit())
      return error("glfw", "no window system: " + lastError(), "use --backend egl or osmesa, or set DISPLAY");
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, request.window ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(request.width, request.height, request.title.c_str(), nullptr,
                                          share ? share->window_ : nullptr);
    if (!window) {
      const std::string reason = lastError();
      if (!share) glfwTerminate();
      return error("glfw", "gives no OpenGL 4.5 core window: " + reason, "use --backend egl or osmesa");
    }
    auto made = std::make_unique<GlfwBackend>(window, share == nullptr);
    if (share) {
      made->shareFunctions(share->info_);
    } else {
      made->makeCurrent();
      made->loadFunctions(reinterpret_cast<void* (*)(const char*)>(glfwGetProcAddress));
      glfwSwapInterval(1);
    }
    return std::unique_ptr<Context>(std::move(made));
  }

 private:
  GLFWwindow* window_;
  bool owner_;
};

}  // namespace

Result<std::unique_ptr<Context>> createGlfwContext(const ContextRequest& request) {
  return GlfwBackend::make(request, nullptr);
}

}  // namespace glint::gl
