// A failing check draws one picture per test, and errors in drawing have no other effect.

#include "helpers/picture.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "helpers/scoped_environment.hpp"
#include "helpers/scratch_folder.hpp"
#include "helpers/story.hpp"
#include "pages/failure/failure_panels.hpp"

namespace cs550::test {
namespace {

namespace fs = std::filesystem;

/// A temporary folder for pictures.
class Picture : public testing::Test {
 protected:
  std::string written() const {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ifstream file(folder / ("Picture." + test + ".svg"));
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  const ScratchFolder scratch;
  const fs::path folder = scratch / "pictures";  // made with the first picture

 private:
  const ScopedEnvironment variable_{"CS550_PICTURES", folder.string()};
};

TEST_F(Picture, IsNotDrawnWhileTheChecksHold) {
  Story story("Two is two");
  story.picture([]() -> std::string { throw std::runtime_error("drawn all the same"); });
  EXPECT_TRUE(story.expect_equal("two", 2, 2));
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Picture, IsWrittenAndNamedByTheFirstFailure) {
  Story story("Two is three");
  story.picture([] { return "<svg/>"; });
  EXPECT_NONFATAL_FAILURE(story.expect_equal("two", 2, 3), "picture   ");
  EXPECT_EQ(written(), "<svg/>");
  Story second("Two is four");
  second.picture([] { return "<svg>later</svg>"; });
  EXPECT_NONFATAL_FAILURE(second.expect_equal("two", 2, 4), "expected  4");
  EXPECT_EQ(written(), "<svg/>");
}

TEST_F(Picture, ThatCannotBeDrawnIsLeftOut) {
  Story story("Two is three");
  story.picture([]() -> std::string { throw 5; });
  EXPECT_NONFATAL_FAILURE(story.expect_equal("two", 2, 3), "expected  3");
  EXPECT_EQ(written(), "");
}

TEST_F(Picture, ThatCannotBeWrittenIsLeftOut) {
  std::ofstream(folder) << "a file where the folder should be";
  Story story("Two is three");
  story.picture([] { return "<svg/>"; });
  EXPECT_NONFATAL_FAILURE(story.expect_equal("two", 2, 3), "expected  3");
  EXPECT_TRUE(fs::is_regular_file(folder));
}

TEST_F(Picture, ShowsTheGotBesideTheExpected) {
  drawing::Drawing expected;
  expected.title = "one point";
  expected.points.push_back({{0, 0, 0}, drawing::Role::Expected, 4});
  drawing::Drawing got = expected;
  got.points[0].position.x() = NAN;
  const std::string svg = expected_beside_got("A point", expected, got);
  EXPECT_NE(svg.find("Expected: one point"), std::string::npos);
  EXPECT_NE(svg.find("Got: one point"), std::string::npos);
  EXPECT_NE(svg.find("not finite"), std::string::npos);
}

TEST_F(Picture, ContainsItsDrawingsForTheViewer) {
  drawing::Drawing expected;
  expected.points.push_back({{1, 2, 3}, drawing::Role::Expected, 4});
  drawing::Drawing got = expected;
  got.points[0].position = {7, 8, 9};
  const auto panels = pages::panels_in(
      expected_beside_got("A point", expected, got, drawing::view_from_above(), ""));
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].content.drawing.title, "Expected: ");
  EXPECT_EQ(panels[1].content.drawing.points.at(0).position, Vec3(7, 8, 9));
  EXPECT_EQ(panels[1].toward_eye, Vec3::UnitZ());
  EXPECT_EQ(panels[1].content.focus, panels[0].content.focus);
  EXPECT_TRUE(pages::panels_in("<svg></svg>").empty());
}

}  // namespace
}  // namespace cs550::test
