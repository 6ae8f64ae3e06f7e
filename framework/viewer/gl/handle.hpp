#pragma once
/// @file handle.hpp
/// Owning handles of OpenGL objects: the object is deleted with its handle.

#include <epoxy/gl.h>

#include <cstdint>
#include <utility>

namespace cs550::viewer {

/// Owns one OpenGL object. @tparam Kind has `static GLuint make()` and `static void drop(GLuint)`
template <class Kind>
class Handle {
 public:
  Handle() : name_(Kind::make()) {}
  ~Handle() {
    if (name_ != 0) Kind::drop(name_);
  }
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  /// OpenGL's name of the object.
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

/// The kinds of objects that the viewer uses.
/// @{
struct BufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void drop(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayKind {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void drop(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureKind {
  static GLuint make() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void drop(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void drop(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void drop(GLuint name) { glDeleteFramebuffers(1, &name); }
};
/// @}

using Buffer = Handle<BufferKind>;
using VertexArray = Handle<VertexArrayKind>;
using Texture = Handle<TextureKind>;
using Renderbuffer = Handle<RenderbufferKind>;
using Framebuffer = Handle<FramebufferKind>;

/// An offset into a buffer. OpenGL takes it as a pointer, for historical reasons.
inline const void* buffer_offset(std::uintptr_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace cs550::viewer
