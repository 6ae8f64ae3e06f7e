#include "viewer/options.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "cs550/excerpt.hpp"
#include "cs550/scene.hpp"
#include "files/indented.hpp"
#include "files/path_argument.hpp"
#include "files/usage_fault.hpp"
#include "pages/base/camera.hpp"

namespace cs550::viewer {

namespace {

constexpr int good = 0;
constexpr int misused = 2;
constexpr int smallest_side = 64;
constexpr int largest_side = 8192;

/// Parses "1280x720".
Size parse_size(const std::string& text) {
  Size size;
  char cross = 0;
  char rest = 0;
  std::istringstream words(text);
  words >> size.width >> cross >> size.height;
  const auto is_good = [](int side) { return side >= smallest_side && side <= largest_side; };
  if (words.fail() || words >> rest || cross != 'x' || !is_good(size.width) ||
      !is_good(size.height)) {
    throw CLI::ValidationError("--size", "'" + text +
                                             "' is not WIDTHxHEIGHT in pixels, each from 64 to "
                                             "8192, as in --size 1280x720");
  }
  return size;
}

CLI::Validator ends_in(const std::string& ending) {
  return {[ending](const std::string& file) { return files::fault_of_ending(file, ending); }, ""};
}

bool parse_switch(const std::string& text) {
  if (text == "on" || text == "off") return text == "on";
  throw CLI::ValidationError("--ui", "'" + text + "' is neither on nor off");
}

// Each option has a text and short lines, so that --help fits 80 columns.
void declare(CLI::App& app, Options& options) {
  app.get_formatter()->column_width(22);
  app.add_option("SCENE", options.scene, "a shipped scene, or the path of a scene file")
      ->option_text("(wall)")
      ->check(fault_of_scene_name);
  auto* lab = app.add_option("--lab", options.lab, "show the page of this lab instead of a scene")
                  ->option_text("N")
                  ->check(CLI::Range(1, lab_page_count));
  app.add_option("--failure", options.failure,
                 "show the case in which a test failed, as in\n"
                 "--failure Lab4.AxisMatchesBruteForce")
      ->option_text("TEST")
      ->check(files::fault_of_path)
      ->excludes(lab);
  app.add_flag("--student", options.student, "run your own code in labs/ instead of the reference");
  app.add_option("--steps", options.steps, "steps to take before the first picture")
      ->option_text("N")
      ->check(CLI::Range(0, 100000));
  app.add_option("--set", options.settings, "change a setting of the page; may be repeated")
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false);
  auto* list = app.add_flag("--list", options.list, "print the settings of the page and exit");
  app.add_option("--camera", options.camera,
                 "YAW,PITCH[,DISTANCE[,X,Y,Z]]: degrees and metres,\n"
                 "as in --camera=-60,20,8")
      ->option_text("NUMBERS")
      ->check([](const std::string& text) -> std::string {
        try {
          parse_camera(text, {});
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
        return "";
      });
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { options.size = parse_size(text); },
         "size of the picture or window in pixels (1280x720)")
      ->option_text("WIDTHxHEIGHT");
  app.add_option_function<std::string>(
         "--ui", [&](const std::string& text) { options.ui = parse_switch(text); },
         "show panels and plots; hidden if the width is below\n"
         "495 pixels")
      ->option_text("on|off");
  auto* snapshot =
      app.add_option("--snapshot", options.snapshot, "write a PNG file instead of opening a window")
          ->option_text("FILE")
          ->check(ends_in(".png"))
          ->check(files::fault_of_path)
          ->excludes(list);
  app.add_option("--frames", options.frames,
                 "write 0000.png, 0001.png, ... to this folder, one per\n"
                 "step")
      ->option_text("FOLDER")
      ->check(files::fault_of_path)
      ->excludes(list)
      ->excludes(snapshot);
  app.add_option("--gif", options.gif,
                 "write an animation, at most 30 frames a second (needs\n"
                 "ffmpeg or ImageMagick)")
      ->option_text("FILE")
      ->check(ends_in(".gif"))
      ->check(files::fault_of_path)
      ->excludes(list)
      ->excludes(snapshot);
  app.add_option("--frame-count", options.frame_count,
                 "frames for --frames and --gif; by default all steps of\n"
                 "the page, or 120")
      ->option_text("N")
      ->check(CLI::Range(1, 10000));
  app.callback([&options] {
    if (options.frame_count && options.frames.empty() && options.gif.empty()) {
      throw CLI::ValidationError("--frame-count", "only --frames and --gif have frames");
    }
  });
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) option->disable_flag_override();
  }
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
  CommandLine line;
  line.options.arguments.assign(argv + 1, argv + argc);
  CLI::App app("Watch and inspect the engine, in a window or as a picture", "./cs550 view");
  declare(app, line.options);
  app.failure_message([](const CLI::App* parsed, const CLI::Error& error) {
    return files::indented(with_short_words(files::usage_fault(*parsed, error)), 0) +
           "./cs550 view --help explains the options.\n";
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    line.exit_code = app.exit(error) == 0 ? good : misused;
  }
  return line;
}

}  // namespace cs550::viewer
