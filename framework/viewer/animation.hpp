#pragma once
/// @file animation.hpp
/// Numbered pictures as one moving one.

#include <filesystem>

namespace cs550::viewer {

/// A folder for a while.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Makes a GIF of the files 0000.png, 0001.png, … in the folder `frames`, by ffmpeg or ImageMagick.
/// @param rate pictures per second
/// @throws std::runtime_error if neither is here, or the one that is fails
void write_animation(const std::filesystem::path& frames, const std::filesystem::path& file,
                     double rate);

}  // namespace cs550::viewer
