#include "viewer/animation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "files/interruption.hpp"
#include "files/output_file.hpp"

namespace cs550::viewer {

namespace fs = std::filesystem;

namespace {

constexpr int not_found = 127;
constexpr double most_per_second = 30;  ///< pictures; their delays are whole hundredths

/// Runs a program in a folder and discards its output. @return its exit code; not_found if it is not installed
int run(const fs::path& folder, const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    if (chdir(folder.c_str()) != 0) _exit(1);
    execvp(arguments[0], arguments.data());
    _exit(not_found);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// ImageMagick is not the only program with the name `convert`.
bool convert_is_image_magick() {
  FILE* const output = popen("convert -version 2>/dev/null </dev/null", "r");
  if (output == nullptr) return false;
  std::string version(64, '\0');
  version.resize(std::fread(version.data(), 1, version.size(), output));
  return pclose(output) == 0 && version.find("ImageMagick") != std::string::npos;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "cs550-frames-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("cannot create a folder in " + fs::temp_directory_path().string());
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string frame_name(int number) { return fmt::format("{:04}.png", number); }

std::vector<Still> stills(int count, double rate) {
  constexpr double rounding = 1e-3;  // of a rate that is a multiple of the largest one
  const int stride = std::max(1, static_cast<int>(std::ceil(rate / most_per_second - rounding)));
  const auto time_of = [rate](int picture) {
    return static_cast<int>(std::lround(100 * picture / rate));
  };
  std::vector<Still> result;
  for (int i = 0; i < count; i += stride) result.push_back({i, time_of(i + stride) - time_of(i)});
  return result;
}

// The programs run in a folder that has links to these pictures and no others. They would give a meaning to a %
// or a * in the path of the user's folder.
void write_animation(const fs::path& frames, int count, const fs::path& file, double rate) {
  const TemporaryFolder folder;
  for (int i = 0; i < count; ++i) {
    fs::create_symlink(fs::absolute(frames / frame_name(i)), folder.path() / frame_name(i));
  }
  const std::string draft = "animation.gif";
  const int by_ffmpeg =
      run(folder.path(),
          {"ffmpeg", "-y", "-xerror", "-framerate", std::to_string(rate), "-i", "%04d.png", "-vf",
           "fps=" + std::to_string(std::min(rate, most_per_second)) +
               ",split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse="
               "dither=bayer",
           draft});
  files::throw_if_interrupted();
  if (by_ffmpeg == not_found) {
    if (!convert_is_image_magick()) {
      throw std::runtime_error(
          "--gif needs ffmpeg or ImageMagick; install the package ffmpeg or imagemagick");
    }
    std::vector<std::string> command{"convert", "-loop", "0"};
    for (const auto& [picture, delay] : stills(count, rate)) {
      command.insert(command.end(), {"-delay", std::to_string(delay), frame_name(picture)});
    }
    command.insert(command.end(), {"-layers", "Optimize", draft});
    if (run(folder.path(), command) != 0) {
      throw std::runtime_error("ImageMagick could not make " + file.string());
    }
  } else if (by_ffmpeg != 0) {
    throw std::runtime_error("ffmpeg could not make " + file.string());
  }
  files::copy_file(folder.path() / draft, file);
}

}  // namespace cs550::viewer
