#pragma once
/// @file glfw_window.hpp
/// A window with OpenGL in it.

#include "viewer/gl/canvas.hpp"

struct GLFWwindow;

namespace cs550::viewer {

/// GLFW, from its beginning to its end.
class WindowSystem {
 public:
  /// @throws std::runtime_error if there is no screen
  WindowSystem();
  ~WindowSystem();
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;
};

/// A window with OpenGL 3.3, which is current.
class Window {
 public:
  /// @throws std::runtime_error if there is no such OpenGL
  Window(Size size, bool is_visible);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() const { return window_; }
  Size pixels() const;
  /// How much larger than on a screen of 100 dots per inch things should be, beyond what the window
  /// system does by itself.
  float scale() const;

 private:
  GLFWwindow* window_;
};

}  // namespace cs550::viewer
