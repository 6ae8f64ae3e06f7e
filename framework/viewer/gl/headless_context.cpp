#include "viewer/gl/headless_context.hpp"

#include <stdexcept>
#include <string>

namespace cs550::viewer {
namespace {

std::unique_ptr<GlContext> open_any() {
  std::string egl_problem;
  try {
    return open_egl();
  } catch (const std::runtime_error& error) {
    egl_problem = error.what();
  }
  try {
    return open_hidden_window();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("a picture can be drawn neither without a screen (" + egl_problem +
                             ") nor in a hidden window (" + error.what() +
                             ").\nInstall the packages libegl1, libgl1 and libgl1-mesa-dri:\n"
                             "./cs550 doctor --install viewer");
  }
}

}  // namespace

HeadlessContext::HeadlessContext(HeadlessWay way)
    : context_(way == HeadlessWay::Egl            ? open_egl()
               : way == HeadlessWay::HiddenWindow ? open_hidden_window()
                                                  : open_any()) {}

}  // namespace cs550::viewer
