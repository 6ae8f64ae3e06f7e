#include "viewer/gl/canvas.hpp"

#include <algorithm>
#include <string>

namespace cs550::viewer {
namespace {

constexpr GLint wanted_samples = 4;

GLint sample_count() {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  return std::min(most, wanted_samples);
}

void attach(GLenum place, const Renderbuffer& buffer, GLint samples, GLenum format, Size size) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

void copy(GLuint from, GLuint to, Size size) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, to);
}

}  // namespace

Canvas::Canvas(Size size, RenderQuality quality) : size_(size), quality_(quality) {
  const bool is_fine = quality == RenderQuality::Fine;
  const GLint samples = is_fine ? sample_count() : 0;
  glBindFramebuffer(GL_FRAMEBUFFER, result_.name());
  attach(GL_COLOR_ATTACHMENT0, result_colour_, 0, GL_RGBA8, size);
  if (is_fine) {
    glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
    attach(GL_COLOR_ATTACHMENT0, sample_colour_, samples, GL_RGBA8, size);
  }
  attach(GL_DEPTH_ATTACHMENT, depth_, samples, GL_DEPTH_COMPONENT24, size);
}

void Canvas::begin_scene(int scene) {
  const bool is_fine = quality_ == RenderQuality::Fine;
  held_ = is_fine ? scene : 0;
  glBindFramebuffer(GL_FRAMEBUFFER, is_fine ? samples_.name() : result_.name());
  glViewport(0, 0, size_.width, size_.height);
}

void Canvas::resolve() const {
  if (quality_ == RenderQuality::Fine) copy(samples_.name(), result_.name(), size_);
}

void Canvas::show_in_window() const { copy(result_.name(), 0, size_); }

bool draws_in_software() {
  const std::string name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto is_in_name = [&](const char* part) { return name.find(part) != std::string::npos; };
  return is_in_name("llvmpipe") || is_in_name("softpipe") || is_in_name("Software");
}

}  // namespace cs550::viewer
