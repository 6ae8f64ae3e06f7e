// The program behind ./cs550 demo: runs a scene through the assembled engine, prints a summary.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/demo/run_record.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/system/viewer.hpp"
#include "files/interruption.hpp"
#include "files/path_argument.hpp"

namespace {

using namespace cs550;
using namespace cs550::cli;

struct DemoOptions {
  std::string scene = "wall";
  std::filesystem::path csv;
  int steps = 0;                   ///< 0: the scene's own number
  std::optional<Quality> quality;  ///< empty: the scene's own settings
  std::optional<int> threads;      ///< empty: the scene's own number
  bool sleeping = true;
  bool no_picture = false;
};

Quality parse_quality(const std::string& name) {
  if (name == "accurate") return Quality::Accurate;
  if (name == "game") return Quality::Game;
  throw CLI::ValidationError("--quality", "'" + name + "' is neither accurate nor game");
}

bool parse_switch(const std::string& option, const std::string& value) {
  if (value == "on") return true;
  if (value == "off") return false;
  throw CLI::ValidationError(option, "'" + value + "' is neither on nor off");
}

double timed_step(World& world, Real h) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  world.step(h);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Stops before a step that loses the finite state: its figures would mean nothing.
void run_scene(World& world, const Scene& scene, int steps, RunRecord& record,
               std::optional<TrajectoryCsv>& trajectory) {
  ProgressBar progress(steps);
  World before;
  if (trajectory) trajectory->add(world, scene);
  for (int step = 0; step < steps; ++step) {
    files::throw_if_interrupted();
    before = world;
    const double seconds = timed_step(world, scene.h);
    if (!is_finite(world)) {
      record.stop(find_broken_stages(before, scene.h));
      world = before;
      break;
    }
    record.add_step(world, seconds);
    if (trajectory) trajectory->add(world, scene);
    progress.show(step + 1);
  }
  if (trajectory) trajectory->commit();
}

/// A picture of the scene after an eighth of the run, when most happens. It is optional.
void take_picture(const Scene& scene, const DemoOptions& options, int steps) {
  constexpr int moment = 8;
  constexpr int latest = 100000;  // steps that the viewer takes
  const std::string& name = options.scene;
  if (!CS550_HAS_VIEWER) {
    std::cout << "\nFor a picture: ./cs550 view " << name << " (installs the packages it needs)\n";
    return;
  }
  std::vector<std::string> command = viewer_command(false);
  if (command.empty()) return;
  const std::filesystem::path file = project_root() / "build/results" / (scene.name + ".png");
  const std::filesystem::path log = file.string() + ".txt";
  std::filesystem::create_directories(file.parent_path());
  command.insert(
      command.end(),
      {name, "--steps", std::to_string(std::min(steps / moment, latest)), "--ui", "off", "--set",
       options.sleeping ? "sleeping=on" : "sleeping=off", "--snapshot", file.string()});
  if (options.quality) {
    const bool is_game = *options.quality == Quality::Game;
    command.insert(command.end(), {"--set", is_game ? "quality=game" : "quality=accurate"});
  }
  if (run(command, {{}, log}).good()) {
    std::cout << "\nPicture: " << std::filesystem::relative(file).string()
              << "\nIn motion: ./cs550 view " << name << '\n';
  } else {
    std::cout << "\nThe picture could not be made; the viewer's output is in " << log.string()
              << '\n';
  }
}

int run_demo(const DemoOptions& options) {
  SceneResult found = find_scene(options.scene);
  if (!found.missing_step.empty()) {
    print_error("the shapes of a scene need " + found.missing_step +
                ", which is not written yet.\n./cs550 progress prints the next step.");
    return Failed;
  }
  if (!found) {
    print_error(found.error);
    return Misused;
  }
  Scene& scene = found.scene;
  scene.settings.audit_momentum = true;
  if (options.quality && !has_quality(scene.settings, *options.quality)) {
    set_quality(scene.settings, *options.quality);
    scene.max_penetration = 0;  // it was stated for the scene's own quality
  }
  if (options.threads) scene.settings.threads = *options.threads;
  scene.settings.sleeping = options.sleeping;

  files::watch_for_interruption();
  std::optional<TrajectoryCsv> trajectory;
  if (!options.csv.empty()) trajectory.emplace(options.csv);
  World world = make_world(scene);
  RunRecord record(scene, world);
  const int steps = options.steps > 0 ? options.steps : scene.steps;
  run_scene(world, scene, steps, record, trajectory);
  record.print(std::cout);
  if (!options.no_picture) take_picture(scene, options, steps);
  return record.good() ? Good : Failed;
}

void declare(CLI::App& app, DemoOptions& options) {
  app.add_option("SCENE", options.scene,
                 "name of a shipped scene, or a scene file; by default wall");
  app.add_option("--csv", options.csv, "write the trajectory of every moving body to a file")
      ->check(files::fault_of_path)
      ->check([](const std::string& file) { return files::fault_of_ending(file, ".csv"); })
      ->option_text("FILE");
  app.add_option("--steps", options.steps, "number of steps; by default the scene's own")
      ->option_text("N")
      ->check(CLI::Range(1, 1000000));
  app.add_option_function<std::string>(
         "--quality", [&](const std::string& name) { options.quality = parse_quality(name); },
         "accurate, or game: fewer passes; by default the\n"
         "scene's own settings")
      ->option_text("NAME");
  app.add_option("--threads", options.threads,
                 "threads that share the work of a step while that saves\n"
                 "time; by default the scene's own number, 1")
      ->option_text("N")
      ->check(CLI::Range(1, 16));
  app.add_option_function<std::string>(
         "--sleeping",
         [&](const std::string& value) { options.sleeping = parse_switch("--sleeping", value); },
         "on: bodies at rest are skipped until something disturbs\n"
         "them, the default; or off")
      ->option_text("SWITCH");
  app.add_flag("--no-picture", options.no_picture, "print the summary only");
}

}  // namespace

int main(int argc, char** argv) {
  DemoOptions options;
  CLI::App app("Run a scene through the engine; print a summary and save a picture",
               "./cs550 demo");
  declare(app, options);
  return run_verb(app, "demo", argc, argv, [&] { return run_demo(options); });
}
