#include "viewer/window.hpp"

#include <epoxy/gl.h>
// Must follow epoxy, which declares OpenGL's functions.
#include <GLFW/glfw3.h>

#include <imgui/imgui.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "viewer/gl/glfw_window.hpp"
#include "viewer/snapshot_command.hpp"

namespace cs550::viewer {
namespace {

WindowSystem open_screen(const Options& options) {
  try {
    return {};
  } catch (const std::runtime_error& error) {
    throw NoScreen(error.what(), snapshot_command(options));
  }
}

/// With Ctrl the arrow keys move A, with Shift B. @return whether the key was one of these
bool hear_nudge(App& app, int key, int modifiers) {
  const bool is_first = (modifiers & GLFW_MOD_CONTROL) != 0;
  const bool is_last = (modifiers & GLFW_MOD_SHIFT) != 0;
  const Real right = key == GLFW_KEY_RIGHT ? 1 : key == GLFW_KEY_LEFT ? -1 : 0;
  const Real up = key == GLFW_KEY_UP ? 1 : key == GLFW_KEY_DOWN ? -1 : 0;
  if ((!is_first && !is_last) || (right == 0 && up == 0)) return false;
  app.nudge(is_first ? App::Nudged::First : App::Nudged::Last, right, up);
  return true;
}

void hear_key(GLFWwindow* window, int key, int /*scancode*/, int action, int modifiers) {
  auto* app = static_cast<App*>(glfwGetWindowUserPointer(window));
  const bool types_text = ImGui::GetIO().WantTextInput;
  if (action == GLFW_RELEASE || app == nullptr || types_text) return;
  if (hear_nudge(*app, key, modifiers)) return;
  // Of the keys that are held down only those of steps repeat, not those that switch something.
  const bool steps = key == GLFW_KEY_N || key == GLFW_KEY_RIGHT;
  if (action == GLFW_REPEAT && !steps) return;
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_0 + lab_page_count) app->show_page(key - GLFW_KEY_0);
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
  const WindowSystem system = open_screen(options);
  const Window window(options.size, true);
  // Installed before Dear ImGui, which forwards events to earlier callbacks.
  glfwSetKeyCallback(window.get(), hear_key);
  Interface interface(window.get(), window.scale());
  App app(options, interface);
  glfwSetWindowUserPointer(window.get(), &app);
  const bool is_slow = draws_in_software();
  std::optional<Canvas> fine;
  std::optional<Canvas> quick;
  while (glfwWindowShouldClose(window.get()) == GLFW_FALSE) {
    if (app.is_still() && !app.plays()) {
      constexpr double blink = 0.04;  // s; a text cursor blinks, so redraw at least this often
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
      canvas.emplace(size, &canvas == &quick ? RenderQuality::Quick : RenderQuality::Fine);
    }
    app.draw(*canvas);
    canvas->show_in_window();
    glfwSwapBuffers(window.get());
    if (observe && !observe(app)) break;
  }
}

}  // namespace cs550::viewer
