#pragma once
/// @file animation.hpp
/// Turns numbered pictures into an animation.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::viewer {

/// A temporary folder, deleted with the object.
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

/// The name of a picture of a sequence: 0000.png, 0001.png, …
std::string frame_name(int number);

/// One picture of an animation.
struct Still {
  int picture = 0;  ///< its number in the sequence
  int delay = 0;    ///< hundredths of a second

  bool operator==(const Still&) const = default;
};

/// The pictures of an animation that runs as fast as its sequence, at most 30 of them a second.
/// @param rate pictures of the sequence per second
std::vector<Still> stills(int count, double rate);

/// Makes a GIF from the first pictures of a sequence in a folder, with ffmpeg or ImageMagick.
/// @param count of the pictures; the folder may have more, from an earlier run
/// @param rate pictures per second
/// @throws std::runtime_error if neither is installed, or the installed one fails
void write_animation(const std::filesystem::path& frames, int count,
                     const std::filesystem::path& file, double rate);

}  // namespace cs550::viewer
