// The layout of panels and picture.
#include "viewer/ui/layout.hpp"

#include <gtest/gtest.h>

#include "viewer/app.hpp"
#include "viewer/gl/headless_context.hpp"
#include "viewer/snapshot.hpp"

namespace cs550::test {
namespace {

using namespace viewer;

const Size sizes[] = {{64, 64},     {200, 1200},  {495, 300},   {640, 360},  {800, 600},
                      {944, 700},   {960, 540},   {1024, 768},  {1200, 680}, {1280, 720},
                      {1366, 768},  {1920, 1080}, {1080, 1920}, {2000, 300}, {2560, 1440},
                      {3840, 2160}, {8192, 8192}};

/// Checks that the areas are side by side, as high as the window, and without gaps.
void expect_covers(const Layout& layout, Size window) {
  float right = 0;
  for (const Area& area : {layout.panel, layout.picture, layout.plots}) {
    if (area.width == 0) continue;
    EXPECT_EQ(area.left, right);
    EXPECT_EQ(area.top, 0);
    EXPECT_EQ(area.height, static_cast<float>(window.height));
    right = area.left + area.width;
  }
  EXPECT_EQ(right, static_cast<float>(window.width));
}

TEST(Layout, ThePictureHasAtLeastHalf) {
  for (const Size size : sizes) {
    for (const float screen_scale : {1.0F, 1.5F, 2.0F, picture_scale(size)}) {
      for (const bool has_plots : {false, true}) {
        SCOPED_TRACE(testing::Message() << size.width << " x " << size.height << ", scale "
                                        << screen_scale << ", plots " << has_plots);
        const Layout layout = lay_out(size, panel_scale(size, screen_scale), has_plots);
        EXPECT_GE(layout.picture.width, 0.5F * static_cast<float>(size.width));
        expect_covers(layout, size);
        const bool shows_plots = layout.plots.width > 0 || layout.plots_are_inside;
        EXPECT_EQ(shows_plots, has_plots && layout.panel.width > 0);
      }
    }
  }
}

TEST(Layout, SmallWindowsLosePlotsBesideThePictureFirst) {
  const auto of = [](Size size) { return lay_out(size, panel_scale(size, 1), true); };
  EXPECT_GT(of({1280, 720}).plots.width, 0);
  EXPECT_GT(of({960, 540}).plots.width, 0);
  EXPECT_TRUE(of({800, 600}).plots_are_inside);
  EXPECT_TRUE(of({640, 360}).plots_are_inside);
  EXPECT_TRUE(of({495, 360}).plots_are_inside);
  EXPECT_EQ(of({494, 360}).panel.width, 0);
}

TEST(Layout, TextStaysLegible) {
  for (const Size size : sizes) {
    EXPECT_GE(panel_scale(size, 1), 0.75F);
    EXPECT_LE(panel_scale(size, 1), 1.0F);
  }
  EXPECT_EQ(panel_scale({1280, 720}, 1), 1.0F);
  EXPECT_EQ(panel_scale({2560, 1440}, 1), 1.0F) << "a large window shows more, not larger things";
  EXPECT_EQ(panel_scale({2560, 1440}, 2), 2.0F) << "a fine screen shows as much, but finer";
}

TEST(Layout, ALargePictureIsTheSameButFiner) {
  EXPECT_EQ(picture_scale({2560, 1440}), 2.0F);
  EXPECT_EQ(picture_scale({640, 360}), 1.0F);
  const Size large{2560, 1440};
  const Layout layout = lay_out(large, panel_scale(large, picture_scale(large)), true);
  const Layout usual = lay_out({1280, 720}, 1, true);
  EXPECT_EQ(layout.picture.left, 2 * usual.picture.left);
  EXPECT_EQ(layout.picture.width, 2 * usual.picture.width);
}

/// The layout of every page while the size of one window changes.
TEST(Layout, EveryPageFollowsIt) {
  const HeadlessContext context;
  Interface interface(nullptr, 1);
  Options options;
  options.scene = "bounce";
  options.steps = 5;
  App app(options, interface);
  for (const Size size : {Size{640, 360}, Size{800, 600}, Size{1280, 720}, Size{2560, 1440}}) {
    Canvas canvas(size);
    for (int lab = 0; lab <= lab_page_count; ++lab) {
      app.open(lab);
      app.draw(canvas);
      const Layout layout = app.layout();
      EXPECT_GE(layout.picture.width, 0.5F * static_cast<float>(size.width)) << "page " << lab;
      expect_covers(layout, size);
    }
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace cs550::test
