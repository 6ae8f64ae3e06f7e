// Memory and time over many frames.
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "cs550/primitives.hpp"
#include "pages/base/colours.hpp"
#include "pages/failure/failure_panels.hpp"
#include "pictures.hpp"
#include "viewer/app.hpp"
#include "viewer/gl/headless_context.hpp"
#include "viewer/ui/captions.hpp"
#include "viewer/ui/plot_widget.hpp"

namespace cs550::test {
namespace {

using namespace viewer;

class Frames : public testing::Test {
 protected:
  HeadlessContext context;
  Interface ui{nullptr, 1};
};

/// The minimum of allocated memory over a number of frames (bytes). The value after the last frame
/// is too noisy. llvmpipe, Mesa's software driver, writes its commands into blocks of 64 KiB and
/// keeps them until the same list of commands is reused. The number of kept blocks depends on its
/// threads: up to 80 of them, 5 MB, were observed to come and go. Large buffers, such as the 1 MB
/// of the plots' vertices, are sometimes in the heap and sometimes mapped separately, because
/// malloc adapts its threshold when memory is freed.
std::size_t least_bytes_in_use(App& app, Canvas& canvas, int frames) {
  std::size_t least = SIZE_MAX;
  for (int i = 0; i < frames; ++i) {
    app.draw(canvas);
    glFinish();
    const struct mallinfo2 info = mallinfo2();
    least = std::min(least, info.uordblks + info.hblkhd);
  }
  return least;
}

/// A running scene with all overlays and full plots.
TEST_F(Frames, AThousandDoNotGrowLong) {
  Options options;
  options.scene = "bounce";
  options.steps = 950;  // more than the plots keep
  for (const char* overlay : {"contacts", "impulses", "bounds", "tree", "velocities"}) {
    options.settings.push_back(std::string(overlay) + "=on");
  }
  App app(options, ui);
  Canvas canvas({320, 180});
  app.toggle_play();
  constexpr int half = 500;  // frames
  least_bytes_in_use(app, canvas, 100);
  const std::size_t before = least_bytes_in_use(app, canvas, half);
  const std::size_t after = least_bytes_in_use(app, canvas, half);
  const auto growth = static_cast<std::ptrdiff_t>(after - before);
  // At 60 frames a second, 32 bytes per frame fill 150 MB in a day.
  EXPECT_LT(growth, 32 * half) << "bytes in " << half << " frames";
}

TEST_F(Frames, EveryPageCanBeLeftAndEntered) {
  Options options;
  options.scene = "bounce";
  App app(options, ui);
  Canvas canvas({320, 180});
  for (int lab = 7; lab >= 0; --lab) {
    app.open(lab);
    app.draw(canvas);
    app.advance();
    app.draw(canvas);
    EXPECT_EQ(app.page().lab(), lab);
    EXPECT_EQ(app.page().content().problem, "");
  }
}

/// The key of a page may be pressed while it is shown.
TEST_F(Frames, AnOpenPageStaysAsItIs) {
  Options options;
  options.lab = 3;
  App app(options, ui);
  const Page* const shown = &app.page();
  app.show_page(3);
  EXPECT_EQ(&app.page(), shown);
  app.show_page(5);
  EXPECT_EQ(app.page().lab(), 5);
}

TEST_F(Frames, TheTitleNamesTheStudentsCode) {
  for (const bool student : {false, true}) {
    Options options;
    options.scene = "bounce";
    options.student = student;
    App app(options, ui);
    for (int lab = 0; lab <= lab_page_count; ++lab) {
      app.open(lab);
      EXPECT_EQ(app.title(), app.page().title() + (student ? " (your code)" : ""));
    }
  }
}

TEST_F(Frames, StepsCountTheWalkOfTheSettings) {
  Options options;
  options.lab = 1;
  options.settings = {"seconds=10"};  // the default is half as long
  options.steps = 400;
  const App app(options, ui);
  EXPECT_EQ(app.page().content().facts.front().value, "6.67 s");
}

/// A later run of the test may have removed the picture.
TEST_F(Frames, TheFailureStaysWhenItsPictureIsGone) {
  const std::filesystem::path picture =
      std::filesystem::temp_directory_path() / ("Lab3.Gone" + std::to_string(getpid()) + ".svg");
  std::ofstream(picture) << with_panels("<svg></svg>", std::vector<FailurePanel>(3));
  Options options;
  options.failure = picture;
  App app(options, ui);
  std::filesystem::remove(picture);
  const std::string title = app.page().title();
  app.reset();
  EXPECT_EQ(app.page().title(), title);
  app.open(3);
  EXPECT_NE(app.page().title(), title);
  app.open(failure_page);
  EXPECT_EQ(app.page().title(), title);
  Canvas canvas({320, 180});
  app.draw(canvas);
  EXPECT_EQ(app.page().content().problem, "");
}

TEST_F(Frames, EachPanelOfAFailureIsInThePicture) {
  const std::filesystem::path picture =
      std::filesystem::temp_directory_path() / ("Lab3.Far" + std::to_string(getpid()) + ".svg");
  std::vector<FailurePanel> panels(2);
  panels[1].content.focus = {Vec3(100, 0, 0), 1};
  std::ofstream(picture) << with_panels("<svg></svg>", panels);
  Options options;
  options.failure = picture;
  App app(options, ui);
  std::filesystem::remove(picture);
  Canvas canvas({320, 180});
  app.draw(canvas);
  EXPECT_EQ(app.camera().target, Vec3(100, 0, 0)) << "the last panel is shown first";
  app.advance();
  app.draw(canvas);
  EXPECT_EQ(app.camera().target, Vec3(0, 0, 0));
}

TEST_F(Frames, APageWithoutStepsDoesNotPlay) {
  Options options;
  options.lab = 4;
  App app(options, ui);
  EXPECT_FALSE(app.can_step());
  app.toggle_play();
  EXPECT_FALSE(app.plays());
  app.open(5);
  EXPECT_TRUE(app.can_step());
  app.toggle_play();
  EXPECT_TRUE(app.plays());
  app.toggle_play();
  EXPECT_FALSE(app.plays());
}

/// A frame without a window takes a sixtieth of a second.
TEST_F(Frames, TheWorldKeepsPaceWithTheClock) {
  const std::filesystem::path scene =
      std::filesystem::temp_directory_path() / ("cs550-pace-" + std::to_string(getpid()) + ".json");
  Canvas canvas({160, 90});
  for (const auto& [h, steps] :
       {std::pair{"0.002", 250}, {"0.0083333333", 60}, {"0.016666667", 30}, {"0.05", 10}}) {
    std::ofstream(scene) << R"({"schema": 1, "h": )" << h << R"(, "bodies": [
      {"shape": {"kind": "box", "half_extents": [1, 1, 1]}, "mass": 1}]})";
    Options options;
    options.scene = scene;
    App app(options, ui);
    app.toggle_play();
    for (int frame = 0; frame < 30; ++frame) app.draw(canvas);
    EXPECT_EQ(app.world()->frame().step, steps) << h;
  }
  std::filesystem::remove(scene);
}

/// As in pictures: a value without finite neighbours is a dot, and a note counts those that are left out.
TEST_F(Frames, APlotShowsWhatIsNotFiniteAsPicturesDo) {
  Canvas canvas({400, 300});
  const auto shown = [&](const std::vector<Vec2>& values, drawing::SeriesStyle style) {
    drawing::Plot plot;
    drawing::add_series(plot, "energy", values, style);
    ui.begin_frame(canvas.size(), true);
    ImGui::SetNextWindowSize({300, 280});
    ImGui::Begin("plot");
    show_plot(plot, 200, ui.fonts());
    const std::pair result{ImGui::GetWindowDrawList()->VtxBuffer.Size, ImGui::GetCursorPosY()};
    ImGui::End();
    ui.end_frame();
    return result;
  };
  const std::vector<Vec2> with_a_gap{{0, 1}, {1, NAN}, {2, 3}};
  const auto [dots, bottom_of_dots] = shown(with_a_gap, drawing::SeriesStyle::Dots);
  const auto [curve, bottom] = shown(with_a_gap, drawing::SeriesStyle::Curve);
  EXPECT_EQ(curve, dots);
  EXPECT_GT(bottom, shown({{0, 1}, {2, 3}}, drawing::SeriesStyle::Curve).second);
}

/// Many labels at one point: there is room for a few of them.
TEST_F(Frames, OnlyLabelsInThePictureAreMissed) {
  const Size size{400, 300};
  const Area area{0, 0, 400, 300};
  Canvas canvas(size);
  const auto missing_at = [&](const Vec3& place) {
    drawing::Drawing drawing;
    for (int i = 0; i < 40; ++i) drawing.labels.push_back({place, "label", drawing::Role::Text});
    ui.begin_frame(size, false);
    const Projection seen(fitted({}, Vec3::Zero(), 1), size, area);
    const int missing = show_labels(drawing, seen, area, ui.fonts());
    ui.end_frame();
    return missing;
  };
  EXPECT_GT(missing_at(Vec3::Zero()), 10);
  EXPECT_EQ(missing_at({0, 0, 5}), 0) << "above the picture";
}

TEST_F(Frames, EverySizeCanBeDrawn) {
  Options options;
  options.lab = 4;
  App app(options, ui);
  for (const Size size : {Size{64, 64}, Size{2000, 300}, Size{300, 1200}, Size{1, 1}}) {
    Canvas canvas(size);
    app.draw(canvas);
    app.draw(canvas);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << size.width;
  }
}

/// A cube of boxes.
Content boxes(Index per_side) {
  const TriangleSoup box = box_soup({0.4F, 0.4F, 0.4F});
  const ShapeResult shape = make_shape(box.vertices, box.triangles);
  const auto mesh = std::make_shared<const HalfEdgeMesh>(shape.shape->mesh);
  Content content;
  for (Index i = 0; i < per_side * per_side * per_side; ++i) {
    Solid solid;
    solid.mesh = mesh;
    solid.pose.position =
        Eigen::Vector3i(i % per_side, i / per_side % per_side, i / per_side / per_side)
            .cast<Real>();
    solid.colour = body_colour(0, i);
    content.solids.push_back(solid);
  }
  const Real middle = Real(0.5) * static_cast<Real>(per_side - 1);
  content.focus = {Vec3::Constant(middle), static_cast<Real>(per_side - 1)};
  return content;
}

Projection view_of(const Content& content, Size size, Real turn = 0) {
  Camera camera;
  camera.orbit(turn, 0);
  return {fitted(camera, content.focus.center, content.focus.radius), size,
          Area{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)}};
}

/// A skipped picture must be equal to the one that would have been drawn.
TEST_F(Frames, AnOldContentRendererPaintsWhatANewOneDoes) {
  const Size size{320, 180};
  Content content = boxes(3);
  Canvas canvas(size);
  ContentRenderer renderer;
  const auto expect_fresh = [&](const char* change, Real turn, float scale) {
    const Projection projection = view_of(content, size, turn);
    renderer.paint(content, projection, canvas, scale);
    Canvas fresh(size);
    ContentRenderer().paint(content, projection, fresh, scale);
    EXPECT_TRUE(viewer::read_picture(canvas).pixels == viewer::read_picture(fresh).pixels)
        << change;
    EXPECT_EQ(renderer.still_frames(), 0) << change;
    renderer.paint(content, projection, canvas, scale);
    EXPECT_TRUE(viewer::read_picture(canvas).pixels == viewer::read_picture(fresh).pixels)
        << change << ", a second time";
    EXPECT_EQ(renderer.still_frames(), 1) << change;
  };
  expect_fresh("nothing", 0, 1);
  content.solids[26].pose.position.z() += Real(0.5);
  expect_fresh("a body moved", 0, 1);
  content.solids[26].colour.w() = 0.5F;
  expect_fresh("a body became glass", 0, 1);
  content.solids.pop_back();
  expect_fresh("a body left", 0, 1);
  content.drawing.lines.push_back({Vec3::Zero(), Vec3(4, 4, 4), {}});
  expect_fresh("a line came", 0, 1);
  expect_fresh("the lines became wider", 0, 2);
  content.drawing = {};
  expect_fresh("the line left", 0, 2);
  content.focus.radius *= 2;
  expect_fresh("the shadows reach farther", 0, 2);
  expect_fresh("the camera turned", Real(0.3), 2);
}

/// At half size, one sample per pixel looks like several.
TEST_F(Frames, AQuickOneLooksLikeAFineOne) {
  const Size size{640, 360};
  const Content content = boxes(4);
  std::vector<Picture> pictures;
  for (const RenderQuality quality : {RenderQuality::Fine, RenderQuality::Quick}) {
    Canvas canvas(size, quality);
    ContentRenderer().paint(content, view_of(content, size), canvas, 1);
    pictures.push_back(halved(halved(viewer::read_picture(canvas))));
  }
  EXPECT_GT(colour_count(pictures[0]), 40);
  EXPECT_LT(share_that_differs(pictures[0], pictures[1]), 0.1);
}

/// Only reported, because machines differ.
TEST_F(Frames, ReportsTheTimeOfAThousandBodies) {
  const Size size{1280, 720};
  const Content content = boxes(10);
  for (const RenderQuality quality : {RenderQuality::Quick, RenderQuality::Fine}) {
    Canvas canvas(size, quality);
    ContentRenderer renderer;
    const auto paint = [&](int frame) {
      renderer.paint(content, view_of(content, size, Real(0.01) * static_cast<Real>(frame)), canvas,
                     1);
      glFinish();
    };
    paint(0);
    using Clock = std::chrono::steady_clock;
    std::vector<double> milliseconds;
    for (int frame = 1; frame <= 15; ++frame) {
      const Clock::time_point start = Clock::now();
      paint(frame);
      milliseconds.push_back(
          std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    std::nth_element(milliseconds.begin(), milliseconds.begin() + 7, milliseconds.end());
    const std::string name = quality == RenderQuality::Quick ? "quick" : "fine";
    std::cout << "1,000 boxes at 1280x720, " << name << ": " << milliseconds[7] << " ms a frame\n";
    RecordProperty("milliseconds_per_" + name + "_frame", std::to_string(milliseconds[7]));
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace cs550::test
