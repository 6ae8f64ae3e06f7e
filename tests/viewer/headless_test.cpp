// Pictures without EGL: with a hidden window, or a message with the packages to install.
#include "viewer/gl/headless_context.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "pictures.hpp"
#include "screen.hpp"
#include "viewer/snapshot.hpp"

namespace cs550::test {
namespace {

namespace fs = std::filesystem;
using viewer::HeadlessContext;
using viewer::HeadlessWay;

/// Makes the dispatcher of EGL (libglvnd) find no driver.
const std::string no_egl = "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null";

viewer::Options small_page() {
  viewer::Options options;
  options.lab = 4;
  options.size = {640, 360};
  return options;
}

TEST(Headless, AHiddenWindowDrawsWhatEglDraws) {
  if (!is_installed("Xvfb")) GTEST_SKIP() << "no Xvfb";
  const Screen screen;
  ASSERT_TRUE(screen.is_there());
  std::vector<Picture> pictures;
  for (const HeadlessWay way : {HeadlessWay::Egl, HeadlessWay::HiddenWindow}) {
    const HeadlessContext context(way);
    pictures.push_back(viewer::take_picture(small_page()));
  }
  EXPECT_GT(colour_count(pictures[1]), 40);
  EXPECT_LT(share_that_differs(pictures[0], pictures[1]), 1e-3);
}

class WithoutEgl : public testing::Test {
 protected:
  WithoutEgl()
      : file(fs::temp_directory_path() / ("cs550-no-egl-" + std::to_string(getpid()) + ".png")) {}
  ~WithoutEgl() override { fs::remove(file); }

  Outcome view(std::vector<std::string> command) const {
    const std::vector<std::string> arguments{
        CS550_VIEWER_PROGRAM, "--lab", "4", "--size", "640x360", "--snapshot", file};
    command.insert(command.begin(), "env");
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_program(command);
  }

  fs::path file;
};

TEST_F(WithoutEgl, TheProgramDrawsInAHiddenWindow) {
  if (!is_installed("Xvfb")) GTEST_SKIP() << "no Xvfb";
  const Screen screen;
  ASSERT_TRUE(screen.is_there());
  const Outcome outcome = view({no_egl});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const HeadlessContext context(HeadlessWay::Egl);
  EXPECT_LT(share_that_differs(read_png(file), viewer::take_picture(small_page())), 1e-3);
}

TEST_F(WithoutEgl, AndWithoutAScreenTheProgramSaysWhatToInstall) {
  const Outcome outcome = view({"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", no_egl});
  if (outcome.exit_code == 0) GTEST_SKIP() << "this system's EGL is not libglvnd's";
  EXPECT_EQ(outcome.exit_code, 1);
  for (const char* word : {"neither", "libegl1", "./cs550 doctor --install viewer"}) {
    EXPECT_NE(outcome.output.find(word), std::string::npos) << outcome.output;
  }
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace cs550::test
