#pragma once
/// @file context_egl.hpp
/// OpenGL without a screen.

namespace cs550::viewer {

/// An OpenGL 3.3 context that belongs to no window (EGL, surfaceless): for pictures without a
/// display. At most one at a time.
class HeadlessContext {
 public:
  /// @throws std::runtime_error that names the package to install
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  void* display_;
  void* context_;
};

}  // namespace cs550::viewer
