// Whatever a scene file describes: numbers stay finite, and energy, momentum and distances stay within
// what physics allows. A scene that fails is shrunk and left as a file, for ./cs550 demo FILE.

#include <gtest/gtest.h>

#include <filesystem>

#include "soak/random_scene.hpp"
#include "soak/scene_run.hpp"

namespace cs550 {
namespace {

void run_scenes(std::uint32_t first, std::uint32_t count) {
  const std::filesystem::path folder = testing::TempDir();
  int failed = 0;
  for (std::uint32_t seed = first; seed < first + count && failed < 20; ++seed) {
    const std::filesystem::path file = folder / ("random_scene_" + std::to_string(seed) + ".json");
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

TEST(SceneFuzzer, TwoHundredScenesKeepTheLawsLong) { run_scenes(1, 200); }
TEST(SceneFuzzer, TenThousandScenesKeepTheLawsSoak) { run_scenes(1000, 10000); }

}  // namespace
}  // namespace cs550
