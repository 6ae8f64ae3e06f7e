// Whatever a scene file describes: numbers stay finite, and energy, momentum and distances stay within
// what physics allows. A scene that fails is shrunk and left as a file, for ./cs550 demo FILE.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "helpers/scratch_folder.hpp"
#include "soak/random_scene.hpp"
#include "soak/scene_run.hpp"

namespace cs550 {
namespace {

void run_scenes(std::uint32_t first, std::uint32_t count) {
  const std::filesystem::path folder = testing::TempDir();
  int failed = 0;
  for (std::uint32_t seed = first; seed < first + count && failed < 20; ++seed) {
    const std::filesystem::path file = folder / ("random_scene_" + std::to_string(seed) + "." +
                                                 std::to_string(getpid()) + ".json");
    const nlohmann::json document = test::random_scene(seed);
    const std::string fault = test::fault_of(document, file);
    if (fault.empty()) {
      std::filesystem::remove(file);
      continue;
    }
    ++failed;
    const nlohmann::json smallest = test::shrunk(document, file);
    ADD_FAILURE() << "seed " << seed << ", " << fault << "\nShrunk to " << smallest["bodies"].size()
                  << " bodies and " << smallest["steps"] << " steps: " << file.string();
  }
}

/// Scenes that failed once.
TEST(SceneFuzzer, ScenesThatWereFoundKeepTheLaws) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator("tests/soak/found")) {
    std::ifstream stream(entry.path());
    const nlohmann::json document = nlohmann::json::parse(stream);
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder / entry.path().filename().string();
    EXPECT_EQ(test::fault_of(document, file), "") << entry.path();
    ++scenes;
  }
  EXPECT_GT(scenes, 0) << "tests run in the project's folder";
}

TEST(SceneFuzzer, TwoHundredScenesKeepTheLawsLong) { run_scenes(1, 200); }

/// Ten thousand scenes in twenty pieces, which can run at once.
class SceneFuzzerPiece : public testing::TestWithParam<std::uint32_t> {};

TEST_P(SceneFuzzerPiece, FiveHundredScenesKeepTheLawsSoak) {
  constexpr std::uint32_t piece = 500;
  run_scenes(1000 + piece * GetParam(), piece);
}
INSTANTIATE_TEST_SUITE_P(Seeds, SceneFuzzerPiece, testing::Range(0U, 20U));

}  // namespace
}  // namespace cs550
