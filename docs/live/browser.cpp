// What live.js calls. Each function returns text, or the sentence of a failure after "!".
#include <emscripten/emscripten.h>

#include <functional>
#include <map>

#include "live_figure.hpp"

namespace {

using cs550::Real;
using cs550::live::LiveFigure;

/// Figures by the number that live.js gives them.
std::map<int, std::unique_ptr<LiveFigure>>& figures() {
  static std::map<int, std::unique_ptr<LiveFigure>> all;
  return all;
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

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* live_open(int figure, const char* description) {
  return answer([&] {
    figures()[figure] = std::make_unique<LiveFigure>(description);
    return std::string();
  });
}

EMSCRIPTEN_KEEPALIVE const char* live_set(int figure, const char* assignment) {
  return answer([&] {
    figures().at(figure)->set(assignment);
    return std::string();
  });
}

EMSCRIPTEN_KEEPALIVE const char* live_describe(int figure) {
  return answer([&] { return figures().at(figure)->describe(); });
}

EMSCRIPTEN_KEEPALIVE const char* live_svg(int figure) {
  return answer([&] { return figures().at(figure)->svg(); });
}

EMSCRIPTEN_KEEPALIVE const char* live_plot(int figure, int plot) {
  return answer([&] { return figures().at(figure)->plot_svg(static_cast<std::size_t>(plot)); });
}

EMSCRIPTEN_KEEPALIVE const char* live_facts(int figure) {
  return answer([&] { return figures().at(figure)->facts(); });
}

EMSCRIPTEN_KEEPALIVE void live_advance(int figure) { figures().at(figure)->advance(); }
EMSCRIPTEN_KEEPALIVE void live_rewind(int figure) { figures().at(figure)->rewind(); }
EMSCRIPTEN_KEEPALIVE void live_throw(int figure) { figures().at(figure)->throw_box(); }
EMSCRIPTEN_KEEPALIVE void live_orbit(int figure, float yaw, float pitch) {
  figures().at(figure)->orbit(yaw, pitch);
}
EMSCRIPTEN_KEEPALIVE void live_drag(int figure, float right, float up) {
  figures().at(figure)->drag(right, up);
}

}  // extern "C"
