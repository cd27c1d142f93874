// OSMesa, opened at run time: systems without it (Mesa 25 dropped it) use EGL.
#include <dlfcn.h>

#include <array>
#include <vector>

#include "renderer/gl/context_backends.h"

namespace glint::gl {
namespace {

// From GL/osmesa.h, which newer systems no longer have.
using OSMesaContext = struct osmesa_context*;
constexpr int kFormat = 0x22, kRgba = 0x1908, kDepthBits = 0x30, kStencilBits = 0x31, kProfile = 0x33,
              kCoreProfile = 0x34, kMajor = 0x36, kMinor = 0x37;
constexpr unsigned kUnsignedByte = 0x1401;

struct OsMesa {
  OSMesaContext (*create)(const int*, OSMesaContext) = nullptr;
  void (*destroy)(OSMesaContext) = nullptr;
  unsigned char (*makeCurrent)(OSMesaContext, void*, unsigned, int, int) = nullptr;
  void* (*getProcAddress)(const char*) = nullptr;

  static const OsMesa* get() {
    static const OsMesa* instance = []() -> const OsMesa* {
      void* library = nullptr;
      for (const char* file : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
        if ((library = dlopen(file, RTLD_NOW | RTLD_LOCAL))) break;
      if (!library) return nullptr;
      static OsMesa m;
      m.create = reinterpret_cast<decltype(m.create)>(dlsym(library, "OSMesaCreateContextAttribs"));
      m.destroy = reinterpret_cast<decltype(m.destroy)>(dlsym(library, "OSMesaDestroyContext"));
      m.makeCurrent = reinterpret_cast<decltype(m.makeCurrent)>(dlsym(library, "OSMesaMakeCurrent"));
      m.getProcAddress = reinterpret_cast<decltype(m.getProcAddress)>(dlsym(library, "OSMesaGetProcAddress"));
      return m.create && m.destroy && m.makeCurrent && m.getProcAddress ? &m : nullptr;
    }();
    return instance;
  }
};

class OsMesaBackend final : public Context {
 public:
  OsMesaBackend(OSMesaContext context) : context_(context) {}
  ~OsMesaBackend() override {
    if (current_) release();
    OsMesa::get()->destroy(context_);
  }
  Backend backend() const override { return Backend::OsMesa; }
  void makeCurrent() override {
    // OSMesa insists on a window-system buffer; Glint draws to framebuffer objects only.
    current_ = OsMesa::get()->makeCurrent(context_, buffer_.data(), kUnsignedByte, kSide, kSide);
    GLINT_CHECK(current_, "OSMesaMakeCurrent");
    setStandardState();
  }
  void release() override {
    OsMesa::get()->makeCurrent(nullptr, nullptr, 0, 0, 0);
    current_ = false;
  }
  Result<std::unique_ptr<Context>> createShared() override { return make(context_, &info_); }

  static Result<std::unique_ptr<Context>> make(OSMesaContext share, const Info* info) {
    const OsMesa* mesa = OsMesa::get();
    if (!mesa)
      return error("osmesa", "libOSMesa.so.8 is not on this machine", "install libosmesa6 or use --backend egl");
    const int attributes[] = {kFormat, kRgba, kDepthBits, 24, kStencilBits, 8, kProfile, kCoreProfile,
                              kMajor, 4, kMinor, 5, 0};
    OSMesaContext context = mesa->create(attributes, share);
    if (!context) return error("osmesa", "gives no OpenGL 4.5 core context", "use --backend egl");
    auto made = std::make_unique<OsMesaBackend>(context);
    if (info) {
      made->shareFunctions(*info);
    } else {
      made->makeCurrent();
      made->loadFunctions(mesa->getProcAddress);
    }
    return std::unique_ptr<Context>(std::move(made));
  }

 private:
  static constexpr int kSide = 16;
  OSMesaContext context_;
  std::array<unsigned char, kSide * kSide * 4> buffer_{};
  bool current_ = false;
};

}  // namespace

Result<std::unique_ptr<Context>> createOsMesaContext() { return OsMesaBackend::make(nullptr, nullptr); }

}  // namespace glint::gl
