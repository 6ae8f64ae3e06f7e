#include "viewer/gl/glfw_window.hpp"

#include <epoxy/gl.h>
// Must follow epoxy, which declares OpenGL's functions.
#include <GLFW/glfw3.h>

#include <stdexcept>
#include <string>

#include "viewer/gl/headless_context.hpp"

namespace cs550::viewer {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

class HiddenWindow final : public GlContext {
 private:
  WindowSystem system_;
  Window window_{{64, 64}, false};
};

}  // namespace

WindowSystem::WindowSystem() {
  if (glfwInit() == GLFW_FALSE) {
    throw std::runtime_error("cannot open a window: " + last_error());
  }
}

WindowSystem::~WindowSystem() { glfwTerminate(); }

Window::Window(Size size, bool is_visible) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, is_visible ? GLFW_TRUE : GLFW_FALSE);
  window_ = glfwCreateWindow(size.width, size.height, "CS550", nullptr, nullptr);
  if (window_ == nullptr) {
    throw std::runtime_error("cannot open a window with OpenGL 3.3: " + last_error());
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
}

Window::~Window() { glfwDestroyWindow(window_); }

Size Window::pixels() const {
  Size size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

float Window::scale() const {
  float wanted = 1;
  glfwGetWindowContentScale(window_, &wanted, nullptr);
  int width = 0;
  glfwGetWindowSize(window_, &width, nullptr);
  const float given =
      width > 0 ? static_cast<float>(pixels().width) / static_cast<float>(width) : 1;
  return wanted / given;
}

std::unique_ptr<GlContext> open_hidden_window() { return std::make_unique<HiddenWindow>(); }

}  // namespace cs550::viewer
