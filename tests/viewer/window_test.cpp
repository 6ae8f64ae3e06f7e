// The viewer in a window on a virtual screen. xdotool moves the mouse and presses keys.
#include "viewer/window.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <deque>
#include <functional>

#include "screen.hpp"

namespace cs550::test {
namespace {

using viewer::App;
using viewer::Options;

void xdotool(std::vector<std::string> words) {
  words.insert(words.begin(), "xdotool");
  const Outcome outcome = run_program(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

/// An action of the user, and its expected effect some frames later.
struct Act {
  std::string name;
  std::function<void(App&)> act;
  std::function<bool(App&)> is_done;
};

/// Performs actions one after another. One without effect after many frames fails.
class Play {
 public:
  explicit Play(std::deque<Act> acts) : acts_(std::move(acts)) {}

  /// @return whether the window stays open
  bool next(App& app) {
    if (acts_.empty()) return true;
    if (waited_++ == 0) acts_.front().act(app);
    if (acts_.front().is_done(app)) {
      acts_.pop_front();
      waited_ = 0;
      return true;
    }
    constexpr int patience = 400;  // frames
    if (waited_ < patience) return true;
    ADD_FAILURE() << acts_.front().name << ": nothing happened";
    return false;
  }
  bool is_over() const { return acts_.empty(); }

 private:
  std::deque<Act> acts_;
  int waited_ = 0;
};

void press_key(const std::string& key) { xdotool({"key", key}); }

void click(int x, int y) {
  xdotool({"mousemove", std::to_string(x), std::to_string(y), "sleep", "0.2", "mousedown", "1",
           "sleep", "0.2", "mouseup", "1"});
}

/// The numbers that a page prints.
std::string numbers(const App& app) {
  std::string all;
  for (const pages::Fact& fact : app.page().content().facts) all += fact.value + '\n';
  return all;
}

TEST(Window, IsOpenedUsedResizedAndClosed) {
  if (!is_installed("Xvfb") || !is_installed("xdotool")) GTEST_SKIP() << "no Xvfb or no xdotool";
  const Screen screen;
  ASSERT_TRUE(screen.is_there());

  Options options;
  options.scene = "bounce";
  options.size = {1280, 720};
  Real yaw = 0;
  Vec3 body_at = Vec3::Zero();
  std::vector<pages::Handle> handles;
  const auto has_moved = [&](const App& app, std::size_t handle) {
    return app.page().handles()[handle].point != handles[handle].point;
  };
  std::string numbers_before;
  const auto steps = [](App& app) { return app.world()->frame().step; };

  Play play({
      {"a first frame",
       [](App&) {
         xdotool({"mousemove", "500", "300"});
       },
       [](App& app) { return app.world() != nullptr && !app.plays(); }},
      {"one step", [](App&) { press_key("n"); }, [&](App& app) { return steps(app) == 1; }},
      {"play", [](App&) { press_key("space"); }, [&](App& app) { return steps(app) > 5; }},
      {"pause", [](App&) { press_key("space"); }, [](App& app) { return !app.plays(); }},
      {"reset", [](App&) { press_key("r"); }, [&](App& app) { return steps(app) == 0; }},
      {"change a setting: the switch of contact points", [](App&) { click(24, 306); },
       [](App& app) { return !app.page().content().drawing.legend.empty(); }},
      {"pick a body",
       [&](App& app) {
         const Vec2 pixel = app.pixel_of(app.world()->frame().bodies[2].pose.position);
         click(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
       },
       [](App& app) { return app.world()->selected() == Index{2}; }},
      {"press the right button",
       [&](App& app) {
         yaw = app.camera().yaw;
         xdotool({"mousemove", "520", "40", "sleep", "0.1", "mousedown", "3"});
       },
       [](App&) { return ImGui::IsMouseDown(ImGuiMouseButton_Right); }},
      {"turn the camera",
       [](App&) {
         xdotool({"mousemove", "440", "60"});
       },
       [&](App& app) { return std::abs(app.camera().yaw - yaw) > Real(0.1); }},
      {"release the button",
       [](App&) {
         xdotool({"mouseup", "3"});
       },
       [](App&) { return !ImGui::IsMouseDown(ImGuiMouseButton_Right); }},
      {"throw a box", [](App&) { press_key("b"); },
       [](App& app) { return app.world()->frame().bodies.size() == 6; }},
      {"drag a body",
       [&](App& app) {
         body_at = app.world()->frame().bodies[2].pose.position;
         app.toggle_play();
         const Vec2 pixel = app.pixel_of(body_at);
         xdotool({"mousemove", std::to_string(static_cast<int>(pixel.x())),
                  std::to_string(static_cast<int>(pixel.y())), "sleep", "0.2", "mousedown", "1"});
       },
       [](App& app) { return app.world()->is_dragging(); }},
      {"let it go",
       [](App&) {
         xdotool({"mouseup", "1"});
       },
       [](App& app) { return !app.world()->is_dragging(); }},
      {"another page", [](App&) { press_key("4"); },
       [](App& app) { return app.page().lab() == 4; }},
      {"take A of the two bodies",
       [&](App& app) {
         handles = app.page().handles();
         const Vec2 pixel = app.pixel_of(handles[0].point);
         xdotool({"mousemove", std::to_string(static_cast<int>(pixel.x())),
                  std::to_string(static_cast<int>(pixel.y())), "sleep", "0.2", "mousedown", "1"});
       },
       [](App&) { return ImGui::IsMouseDown(ImGuiMouseButton_Left); }},
      {"drag it",
       [](App&) {
         xdotool({"mousemove_relative", "--", "-60", "0"});
       },
       [&](App& app) { return has_moved(app, 0) && !has_moved(app, 1); }},
      {"let it go",
       [](App&) {
         xdotool({"mouseup", "1"});
       },
       [](App&) { return !ImGui::IsMouseDown(ImGuiMouseButton_Left); }},
      {"move B by keys", [](App&) { press_key("shift+Up"); },
       [&](App& app) { return has_moved(app, 1); }},
      {"take B with the right button",
       [&](App& app) {
         handles = app.page().handles();
         numbers_before = numbers(app);
         yaw = app.camera().yaw;
         const Vec2 pixel = app.pixel_of(handles[1].point);
         xdotool({"mousemove", std::to_string(static_cast<int>(pixel.x())),
                  std::to_string(static_cast<int>(pixel.y())), "sleep", "0.2", "mousedown", "3"});
       },
       [](App&) { return ImGui::IsMouseDown(ImGuiMouseButton_Right); }},
      {"turn it",
       [](App&) {
         xdotool({"mousemove_relative", "--", "-60", "0"});
       },
       [&](App& app) {
         return numbers(app) != numbers_before && !has_moved(app, 1) && app.camera().yaw == yaw;
       }},
      {"let it go",
       [](App&) {
         xdotool({"mouseup", "3"});
       },
       [](App&) { return !ImGui::IsMouseDown(ImGuiMouseButton_Right); }},
      {"resize",
       [](App&) {
         xdotool({"search", "--name", "CS550", "windowsize", "800", "500"});
       },
       [](App&) { return ImGui::GetIO().DisplaySize.x == 800; }},
      {"hide the panels", [](App&) { press_key("h"); },
       [](App& app) { return app.layout().panel.width == 0; }},
      {"show them again", [](App&) { press_key("h"); },
       [](App& app) { return app.layout().panel.width > 0; }},
      {"close", [](App&) { press_key("Escape"); }, [](App&) { return true; }},
  });
  viewer::run_in_window(options, [&](App& app) { return play.next(app); });
  EXPECT_TRUE(play.is_over());
}

TEST(Window, WithoutAScreenSaysHowToTakeAPicture) {
  const Outcome outcome = run_program({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY",
                                       CS550_VIEWER_PROGRAM, "bounce", "--steps", "9"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("\n./cs550 view bounce --steps 9 --snapshot bounce.png\n"),
            std::string::npos)
      << outcome.output;
}

}  // namespace
}  // namespace cs550::test
