// EGL without a surface: a GPU's driver where there is one, Mesa's software rasteriser otherwise. Opened at
// run time, so that a machine without EGL still runs.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <vector>

#include "renderer/gl/context_backends.h"

namespace glint::gl {
namespace {

using GetProcAddress = void* (*)(const char*);

struct Egl {
  GetProcAddress getProcAddress = nullptr;
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string problem;

  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(getProcAddress(name));
  }

  // One display per process.
  static const Egl& get() {
    static const Egl instance = open();
    return instance;
  }

 private:
  static Egl open() {
    Egl egl;
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library) {
      egl.problem = "libEGL.so.1 is not on this machine";
      return egl;
    }
    egl.getProcAddress = reinterpret_cast<GetProcAddress>(dlsym(library, "eglGetProcAddress"));
    const auto platformDisplay =
        egl.function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const auto initialize = egl.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    const auto queryDevices = egl.function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    std::vector<EGLDisplay> candidates;
    if (platformDisplay) {
      candidates.push_back(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
      // Vendors' drivers without Mesa's platform answer to a device.
      EGLDeviceEXT devices[16];
      EGLint count = 0;
      if (queryDevices && queryDevices(16, devices, &count))
        for (EGLint i = 0; i < count; ++i)
          candidates.push_back(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
    for (EGLDisplay display : candidates) {
      if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) continue;
      egl.display = display;
      return egl;
    }
    egl.problem = "EGL has no display without a surface";
    return egl;
  }
};

class EglBackend final : public Context {
 public:
  explicit EglBackend(EGLContext context) : context_(context) {}
  ~EglBackend() override {
    if (current_) release();
    Egl::get().function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(Egl::get().display, context_);
  }
  Backend backend() const override { return Backend::Egl; }
  void makeCurrent() override {
    current_ = makeCurrent(context_);
    GLINT_CHECK(current_, "eglMakeCurrent");
    setStandardState();
  }
  void release() override {
    makeCurrent(EGL_NO_CONTEXT);
    current_ = false;
  }
  Result<std::unique_ptr<Context>> createShared() override { return make(context_, &info_); }

  static Result<std::unique_ptr<Context>> make(EGLContext share, const Info* info) {
    const Egl& egl = Egl::get();
    if (!egl.problem.empty()) return error("egl", egl.problem, "install libegl1 and libgl1-mesa-dri");
    egl.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    const EGLint configWanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    egl.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")(egl.display, configWanted, &config, 1, &count);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = egl.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(
        egl.display, count ? config : EGL_NO_CONFIG_KHR, share, wanted);
    if (context == EGL_NO_CONTEXT)
      return error("egl", "gives no OpenGL 4.5 core context", "use --backend osmesa");
    auto made = std::make_unique<EglBackend>(context);
    if (info) {
      made->shareFunctions(*info);
    } else {
      made->makeCurrent();
      made->loadFunctions(egl.getProcAddress);
    }
    return std::unique_ptr<Context>(std::move(made));
  }

 private:
  static bool makeCurrent(EGLContext context) {
    return Egl::get().function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(Egl::get().display, EGL_NO_SURFACE,
                                                                        EGL_NO_SURFACE, context);
  }
  EGLContext context_;
  bool current_ = false;
};

}  // namespace

Result<std::unique_ptr<Context>> createEglContext() { return EglBackend::make(EGL_NO_CONTEXT, nullptr); }

}  // namespace glint::gl
