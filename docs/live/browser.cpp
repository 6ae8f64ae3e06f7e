// What worker.js calls. There is one figure in a worker. Each function that can fail returns text, or the
// sentence of a failure after "!".
#include <emscripten/emscripten.h>
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cs550/scene.hpp"
#include "hulls.hpp"
#include "live_figure.hpp"

namespace {

using cs550::Real;
using cs550::live::LiveFigure;

std::unique_ptr<LiveFigure>& figure() {
  static std::unique_ptr<LiveFigure> only;
  return only;
}

/// The text stays until the next call.
const char* answer(const std::function<std::string()>& make) {
  static std::string text;
  try {
    text = make();
  } catch (const std::exception& error) {
    text = std::string("!") + error.what();
  }
  return text.c_str();
}

std::string hash_after(const std::string& name, int steps) {
  const cs550::SceneResult found = cs550::find_scene(name);
  if (!found) throw std::runtime_error(found.error);
  cs550::World world = cs550::make_world(found.scene);
  for (int i = 0; i < steps; ++i) world.step(found.scene.h);
  return fmt::format("{:016x}", world.state_hash());
}

/// The shapes of the last picture.
const std::vector<float>*& picture() {
  static const std::vector<float>* last = nullptr;
  return last;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* live_clouds() {
  return answer([] { return cs550::live::shipped_clouds(); });
}
EMSCRIPTEN_KEEPALIVE const char* live_hulls(const char* hulls) {
  return answer([&] {
    cs550::live::learn_hulls(hulls);
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_hash(const char* scene, int steps) {
  return answer([&] { return hash_after(scene, steps); });
}

EMSCRIPTEN_KEEPALIVE const char* live_open(const char* description) {
  return answer([&] {
    figure() = std::make_unique<LiveFigure>(description);
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_set(const char* assignment) {
  return answer([&] {
    figure()->set(assignment);
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_describe() {
  return answer([] { return figure()->describe(); });
}
/// @param width, height pixels; 0 for the size of the book's still picture
EMSCRIPTEN_KEEPALIVE const char* live_svg(int width, int height) {
  return answer([&] {
    if (width <= 0 || height <= 0) return figure()->svg();
    return figure()->svg({static_cast<double>(width), static_cast<double>(height)});
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_plot(int plot) {
  return answer([&] { return figure()->plot_svg(static_cast<std::size_t>(plot)); });
}
EMSCRIPTEN_KEEPALIVE const char* live_facts() {
  return answer([] { return figure()->facts(); });
}
EMSCRIPTEN_KEEPALIVE const char* live_advance(int steps) {
  return answer([&] {
    for (int i = 0; i < steps; ++i) figure()->advance();
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_rewind() {
  return answer([] {
    figure()->rewind();
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE void live_orbit(float yaw, float pitch) { figure()->orbit(yaw, pitch); }
EMSCRIPTEN_KEEPALIVE void live_zoom(float factor) { figure()->zoom(factor); }
EMSCRIPTEN_KEEPALIVE const char* live_move(int handle, float right, float up) {
  return answer([&] {
    figure()->move(static_cast<std::size_t>(handle), right, up);
    return std::string();
  });
}
EMSCRIPTEN_KEEPALIVE const char* live_turn(int handle, float right, float up) {
  return answer([&] {
    figure()->turn(static_cast<std::size_t>(handle), right, up);
    return std::string();
  });
}

// On a canvas: positions in pixels.
EMSCRIPTEN_KEEPALIVE const char* live_paint(int width, int height) {
  return answer([&] {
    picture() = &figure()->canvas()->paint({width, height});
    return figure()->canvas()->words();
  });
}
EMSCRIPTEN_KEEPALIVE const float* live_shapes() { return picture()->data(); }
EMSCRIPTEN_KEEPALIVE int live_shapes_size() { return static_cast<int>(picture()->size()); }
EMSCRIPTEN_KEEPALIVE const char* live_press(float x, float y) {
  return answer([&] { return std::string(figure()->canvas()->press({x, y}) ? "body" : ""); });
}
EMSCRIPTEN_KEEPALIVE void live_pull(float x, float y) { figure()->canvas()->pull({x, y}); }
EMSCRIPTEN_KEEPALIVE void live_release() { figure()->canvas()->release(); }
EMSCRIPTEN_KEEPALIVE void live_select_next() { figure()->canvas()->select_next(); }
EMSCRIPTEN_KEEPALIVE const char* live_throw(float x, float y) {
  return answer([&] {
    figure()->canvas()->throw_box({x, y});
    return std::string();
  });
}

}  // extern "C"
