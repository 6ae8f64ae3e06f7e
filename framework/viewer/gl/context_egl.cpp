#include "viewer/gl/context_egl.hpp"

#include <epoxy/egl.h>

#include <stdexcept>
#include <string>

namespace cs550::viewer {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw std::runtime_error(std::string(what) +
                           " Install the packages libegl1, libgl1 and libgl1-mesa-dri "
                           "(./cs550 doctor --install viewer).");
}

EGLDisplay open_display() {
  if (!epoxy_has_egl()) refuse("pictures without a screen need libEGL, which is not here.");
  // Mesa's surfaceless platform needs neither a screen nor a graphics card.
  EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
    refuse("EGL finds no OpenGL driver that draws without a screen.");
  }
  return display;
}

EGLContext make_context(EGLDisplay display) {
  eglBindAPI(EGL_OPENGL_API);
  constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT ||
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    refuse("this machine's driver has no OpenGL 3.3.");
  }
  return context;
}

}  // namespace

HeadlessContext::HeadlessContext() : display_(open_display()), context_(make_context(display_)) {}

HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace cs550::viewer
