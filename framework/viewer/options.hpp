#pragma once
/// @file options.hpp
/// The command line of the viewer.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pages/make_page.hpp"
#include "viewer/gl/canvas.hpp"

namespace cs550::viewer {

using namespace pages;

/// The command line's options.
struct Options {
  std::string scene = "wall";         ///< name or path
  int lab = 0;                        ///< page; 0: the world
  std::filesystem::path failure;      ///< picture of a failing test, shown instead of a lab
  bool student = false;               ///< the student's code, in a process of its own
  std::optional<int> steps;           ///< before the first picture
  std::string camera;                 ///< YAW,PITCH[,DISTANCE[,X,Y,Z]]; empty: the page's own
  Size size = {1280, 720};            ///< of the picture or the window (pixels)
  bool ui = true;                     ///< panels
  std::vector<std::string> settings;  ///< name=value
  bool list = false;                  ///< print the settings of the page

  std::filesystem::path snapshot;  ///< PNG file
  std::filesystem::path frames;    ///< folder for a numbered sequence
  std::filesystem::path gif;       ///< animation
  std::optional<int> frame_count;  ///< of a sequence

  std::vector<std::string> arguments;  ///< the words of the command line, without the program

  /// The page to open first (PageChoice).
  PageChoice page() const {
    const Isolation isolation = student ? Isolation::Child : Isolation::Here;
    return {failure.empty() ? lab : failure_page, scene, isolation, failure};
  }
  /// Steps of a scene before the first picture if --steps is missing. A snapshot of the initial
  /// state shows little.
  int default_steps() const { return snapshot.empty() ? 0 : 60; }
  /// Whether a sequence of pictures is written, from the first step.
  bool is_sequence() const { return !frames.empty() || !gif.empty(); }
  /// Whether no window is opened.
  bool is_headless() const { return list || !snapshot.empty() || !frames.empty() || !gif.empty(); }
};

/// The parsed options, or an exit code.
struct CommandLine {
  Options options;
  std::optional<int> exit_code;  ///< 0 after --help, 2 for wrong usage
};

/// Parses the command line; reports errors and how to fix them on standard error.
CommandLine read_command_line(int argc, const char* const* argv);

}  // namespace cs550::viewer
