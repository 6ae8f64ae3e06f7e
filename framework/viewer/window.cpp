#include "viewer/window.hpp"

#include <epoxy/gl.h>
// After epoxy, which brings OpenGL's functions.
#include <GLFW/glfw3.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace cs550::viewer {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

/// GLFW, from its beginning to its end.
class WindowSystem {
 public:
  WindowSystem() {
    if (glfwInit() == GLFW_FALSE) {
      throw std::runtime_error("no window can be opened here (" + last_error() +
                               "). A picture needs none: ./cs550 view --snapshot picture.png");
    }
  }
  ~WindowSystem() { glfwTerminate(); }
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;
};

/// A window with OpenGL 3.3 in it.
class Window {
 public:
  explicit Window(Size size) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    window_ = glfwCreateWindow(size.width, size.height, "CS550", nullptr, nullptr);
    if (window_ == nullptr) {
      throw std::runtime_error("no window with OpenGL 3.3 can be opened (" + last_error() + ")");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  ~Window() { glfwDestroyWindow(window_); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() const { return window_; }

  Size pixels() const {
    Size size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
  }

  /// How much larger than on a screen of 100 dots per inch things should be, beyond what the window
  /// system does by itself.
  float scale() const {
    float wanted = 1;
    glfwGetWindowContentScale(window_, &wanted, nullptr);
    int width = 0;
    glfwGetWindowSize(window_, &width, nullptr);
    const float given =
        width > 0 ? static_cast<float>(pixels().width) / static_cast<float>(width) : 1;
    return wanted / given;
  }

 private:
  GLFWwindow* window_ = nullptr;
};

void hear_key(GLFWwindow* window, int key, int /*scancode*/, int action, int /*modifiers*/) {
  auto* app = static_cast<App*>(glfwGetWindowUserPointer(window));
  if (action == GLFW_RELEASE || app == nullptr) return;
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_0 + lab_page_count) app->open(key - GLFW_KEY_0);
  switch (key) {
    case GLFW_KEY_SPACE:
      app->toggle_play();
      break;
    case GLFW_KEY_N:
    case GLFW_KEY_RIGHT:
      app->advance();
      break;
    case GLFW_KEY_R:
      app->reset();
      break;
    case GLFW_KEY_F:
      app->frame_focus();
      break;
    case GLFW_KEY_H:
      app->toggle_panels();
      break;
    case GLFW_KEY_B:
      app->throw_box();
      break;
    case GLFW_KEY_ESCAPE:
      glfwSetWindowShouldClose(window, GLFW_TRUE);
      break;
    default:
      break;
  }
}

}  // namespace

void run_in_window(const Options& options, const Observer& observe) {
  const WindowSystem system;
  const Window window(options.size);
  // Before Dear ImGui, which hands on what it hears.
  glfwSetKeyCallback(window.get(), hear_key);
  Interface interface(window.get(), window.scale());
  App app(options, interface);
  glfwSetWindowUserPointer(window.get(), &app);
  const bool is_slow = draws_in_software();
  std::optional<Canvas> fine;
  std::optional<Canvas> quick;
  while (glfwWindowShouldClose(window.get()) == GLFW_FALSE) {
    if (app.is_still() && !app.plays()) {
      constexpr double blink = 0.04;  // s; widgets that change by themselves wait no longer
      glfwWaitEventsTimeout(blink);
    } else {
      glfwPollEvents();
    }
    const Size size = window.pixels();
    if (size.width == 0 || size.height == 0) {  // minimised
      glfwWaitEvents();
      continue;
    }
    std::optional<Canvas>& canvas = is_slow && !app.is_still() ? quick : fine;
    if (!canvas || !(canvas->size() == size)) {
      canvas.emplace(size, &canvas == &quick ? Quality::Quick : Quality::Fine);
    }
    app.draw(*canvas);
    canvas->show_in_window();
    glfwSwapBuffers(window.get());
    if (observe && !observe(app)) break;
  }
}

}  // namespace cs550::viewer
