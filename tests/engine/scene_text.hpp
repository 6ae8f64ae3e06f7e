#pragma once
/// @file scene_text.hpp
/// Scenes as text: written to a file, read, and removed.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cs550/scene.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550 {

/// A temporary file, deleted after the test.
class TemporaryScene {
 public:
  explicit TemporaryScene(const std::string& text) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    file_ = folder_ / ("cs550_" + test + ".json");
    std::ofstream(file_) << text;
  }

  const std::filesystem::path& file() const { return file_; }
  SceneResult load() const { return load_scene(file_); }

 private:
  test::ScratchFolder folder_;
  std::filesystem::path file_;
};

inline SceneResult load_text(const std::string& text) { return TemporaryScene(text).load(); }

inline std::string with_body(const std::string& body) {
  return R"({"schema": 1, "bodies": [)" + body + "]}";
}

/// Members of a scene that tests vary: the shape of a body, the body of a generator.
inline constexpr const char* shape_member =
    R"("shape": {"kind": "box", "half_extents": [0.5, 1, 2]})";
inline constexpr const char* body_member =
    R"("body": {"name": "b", "position": [0, 0, 0.5], "shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}})";

}  // namespace cs550
