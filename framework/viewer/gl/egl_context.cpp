#include <stdexcept>

#include "viewer/gl/headless_context.hpp"

#if __has_include(<epoxy/egl.h>)
#include <epoxy/egl.h>

namespace cs550::viewer {
namespace {

/// A display of Mesa's surfaceless platform, which needs neither a screen nor a GPU.
class EglContext final : public GlContext {
 public:
  EglContext() {
    // The functions of a missing extension must not be called.
    if (!epoxy_has_egl() ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
      throw std::runtime_error("libEGL does not support rendering without a screen");
    }
    display_ =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      throw std::runtime_error("EGL found no OpenGL driver");
    }
    if (!make_current()) {
      eglTerminate(display_);
      throw std::runtime_error("the EGL driver does not support OpenGL 3.3");
    }
  }

  ~EglContext() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

 private:
  bool make_current() {
    eglBindAPI(EGL_OPENGL_API);
    constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return context_ != EGL_NO_CONTEXT &&
           eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> open_egl() { return std::make_unique<EglContext>(); }

}  // namespace cs550::viewer

#else

namespace cs550::viewer {

std::unique_ptr<GlContext> open_egl() {
  throw std::runtime_error("libepoxy was built without EGL on this system");
}

}  // namespace cs550::viewer

#endif
