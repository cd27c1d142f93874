// An OpenGL 4.5 core context, from a window (GLFW), without one (EGL surfaceless) or in software (OSMesa).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <optional>

#include "materials/base/diagnostic.h"

struct GLFWwindow;

namespace glint::gl {

enum class Backend { Auto, Glfw, Egl, OsMesa };
std::string_view name(Backend);                       // "auto", "glfw", "egl", "osmesa"
std::optional<Backend> backend(std::string_view name);

struct ContextRequest {
  Backend backend = Backend::Auto;   // Auto: EGL, then OSMesa, without a window; GLFW with one
  bool window = false;               // a visible window: GLFW only
  int width = 1600, height = 900;    // of the window, in screen coordinates
  std::string title = "Glint";
};

// One context, current on the thread that made it until release(). One backend per process: they share
// Mesa's current-context slot.
class Context {
 public:
  // Errors: no such backend on this machine, or less than OpenGL 4.5 core; exit code 3 is for these.
  static Result<std::unique_ptr<Context>> create(const ContextRequest&);
  virtual ~Context() = default;

  virtual Backend backend() const = 0;
  virtual void makeCurrent() = 0;
  virtual void release() = 0;
  // A second context that shares objects with this one, for a worker thread; not current. Call it on the
  // thread that owns this one.
  virtual Result<std::unique_ptr<Context>> createShared() = 0;
  virtual GLFWwindow* window() const { return nullptr; }

  // Queried once at creation.
  struct Info {
    std::string vendor, renderer, version, glsl;
    bool software = false;   // a CPU rasteriser: costs differ (platform.md 5)
  };
  const Info& info() const { return info_; }

 protected:
  void loadFunctions(void* (*getProcAddress)(const char*));  // once current
  // The state that Glint counts on in every context: debug output, seamless cubes, tight rows. Each back end calls it
  // in makeCurrent(); only the first call does anything.
  void setStandardState();
  // A context that shares another's objects takes what was found out there.
  void shareFunctions(const Info& info) {
    info_ = info;
    functionsLoaded_ = true;
  }
  Info info_;

 private:
  bool functionsLoaded_ = false, standardState_ = false;
};

// Errors since the process started, from debug output (GL_DEBUG_TYPE_ERROR, or severity high) on any
// context, each also logged. A test fails when this is not zero.
int errorCount();

}  // namespace glint::gl
