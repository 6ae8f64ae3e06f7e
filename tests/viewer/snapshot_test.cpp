// The picture of every page, compared with its accepted reference.
#include "viewer/snapshot.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <cstdlib>
#include <fstream>

#include "pictures.hpp"
#include "viewer/gl/headless_context.hpp"

namespace cs550::test {
namespace {

namespace fs = std::filesystem;
using viewer::Options;

/// The version of Dear ImGui that drew the references.
constexpr int recorded_with = 18600;

/// CPUs and drivers round differently at edges.
constexpr double tolerated_share = 1e-3;

/// A picture and its expected contents.
struct Case {
  std::string name;  ///< of the reference
  Options options;
  std::array<int, 3> expected_colour;  ///< of the main subject of the page
};

void PrintTo(const Case& test_case, std::ostream* out) { *out << test_case.name; }

Options page(int lab, bool ui) {
  Options options;
  options.lab = lab;
  options.ui = ui;
  if (lab == 0) options.steps = 55;
  options.size = ui ? pages::Size{1280, 720} : pages::Size{640, 360};
  return options;
}

constexpr std::array<int, 3> blue{0, 114, 178};
constexpr std::array<int, 3> orange{230, 159, 0};
constexpr std::array<int, 3> yellow{240, 228, 66};
constexpr std::array<int, 3> brick{98, 163, 204};

const Case cases[] = {
    {"world", page(0, true), brick},
    {"lab1", page(1, true), blue},
    {"lab2", page(2, true), {184, 204, 217}},
    {"lab3", page(3, true), yellow},
    {"lab4", page(4, true), orange},
    {"lab5", page(5, true), yellow},
    {"lab6", page(6, true), yellow},
    {"lab7", page(7, true), yellow},
    {"world_without_panels", page(0, false), brick},
    {"lab3_without_panels", page(3, false), yellow},
    {"lab4_without_panels", page(4, false), orange},
};

fs::path reference_of(const Case& test_case) {
  return fs::path(CS550_VIEWER_REFERENCES) / (test_case.name + ".png");
}

class Snapshot : public testing::TestWithParam<Case> {
 protected:
  viewer::HeadlessContext context;
};

TEST_P(Snapshot, LooksLikeItsReference) {
  const Options& options = GetParam().options;
  Picture picture = viewer::take_picture(options);
  if (options.ui) picture = halved(picture);

  EXPECT_GT(colour_count(picture), 40) << "a blank picture has few colours";
  EXPECT_GT(share_of_colour(picture, GetParam().expected_colour), 2e-4)
      << "the page shows nothing in the colour of what it is about";

  const fs::path reference = reference_of(GetParam());
  if (std::getenv("CS550_UPDATE_REFERENCES") != nullptr) {
    viewer::write_png(picture, reference);
    return;
  }
  const bool has_text = options.ui || options.lab != 0;
  if (has_text && IMGUI_VERSION_NUM != recorded_with) {
    GTEST_SKIP() << "the reference shows letters and widgets of another version of Dear ImGui";
  }
  const double different = share_that_differs(picture, read_png(reference));
  if (different > tolerated_share) {
    const fs::path got = fs::path("build/results/viewer") / reference.filename();
    viewer::write_png(picture, got);
    ADD_FAILURE() << 100 * different << " % of the pixels differ from " << reference << "\n  see "
                  << got << "\n  If it is better than before: CS550_UPDATE_REFERENCES=1 "
                  << "build/test/bin/tests_viewer --gtest_filter='*Snapshot*'";
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Snapshot, testing::ValuesIn(cases),
                         [](const auto& info) { return info.param.name; });

TEST(SnapshotOfNothing, IsFarFromEveryReference) {
  const Picture blank{{640, 360}, std::vector<std::uint8_t>(std::size_t{640} * 360 * 3, 255)};
  EXPECT_LT(colour_count(blank), 2);
  EXPECT_GT(share_that_differs(blank, read_png(reference_of(cases[0]))), 100 * tolerated_share);
}

}  // namespace
}  // namespace cs550::test
