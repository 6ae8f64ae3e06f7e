#pragma once
/// @file glfw_window.hpp
/// A window with an OpenGL context.

#include "viewer/gl/canvas.hpp"

struct GLFWwindow;

namespace cs550::viewer {

/// Initialises GLFW, and terminates it when destroyed.
class WindowSystem {
 public:
  /// @throws std::runtime_error if there is no screen
  WindowSystem();
  ~WindowSystem();
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;
};

/// A window with a current OpenGL 3.3 context.
class Window {
 public:
  /// @throws std::runtime_error if OpenGL 3.3 is not available
  Window(Size size, bool is_visible);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() const { return window_; }
  Size pixels() const;
  /// The scale of text and lines, 1 on a screen of 100 dots per inch. Scaling that the window
  /// system applies itself is not included.
  float scale() const;

 private:
  GLFWwindow* window_;
};

}  // namespace cs550::viewer
