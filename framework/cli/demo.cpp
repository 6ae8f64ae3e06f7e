// ./cs550 demo: a scene through the assembled engine, and a summary of what happened.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "process.hpp"
#include "progress_bar.hpp"
#include "project.hpp"
#include "run_record.hpp"
#include "trajectory_csv.hpp"
#include "verb.hpp"
#include "viewer_program.hpp"

namespace cs550::cli {
namespace {

struct DemoOptions {
  std::string scene = "wall";
  std::filesystem::path csv;
  int steps = 0;  ///< 0: as many as the scene asks for
  bool picture = true;
};

double timed_step(World& world, Real h) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  world.step(h);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void run_scene(World& world, const Scene& scene, int steps, RunRecord& record,
               std::optional<TrajectoryCsv>& trajectory) {
  ProgressBar progress(steps);
  if (trajectory) trajectory->add(world, scene);
  for (int step = 0; step < steps; ++step) {
    record.add_step(world, timed_step(world, scene.h));
    if (trajectory) trajectory->add(world, scene);
    progress.show(step + 1);
  }
  if (trajectory) trajectory->commit();
}

/// A picture of the scene an eighth of the way in, when most happens. A demo is good without one.
void take_picture(const Scene& scene, const std::string& name, int steps) {
  constexpr int moment = 8;
  if (!has_viewer()) {
    std::cout << "\nFor a picture: ./cs550 view " << name << " (it installs what it needs)\n";
    return;
  }
  std::vector<std::string> command = viewer_command(false, "release");
  if (command.empty()) return;
  const std::filesystem::path file = project_root() / "build/results" / (scene.name + ".png");
  const std::filesystem::path said = file.string() + ".txt";
  std::filesystem::create_directories(file.parent_path());
  command.insert(command.end(), {name, "--steps", std::to_string(steps / moment), "--ui", "off",
                                 "--snapshot", file.string()});
  if (run(command, {{}, said}).good()) {
    std::cout << "\nPicture: " << std::filesystem::relative(file).string() << "   ./cs550 view "
              << name << " shows it moving\n";
  } else {
    std::cout << "\nNo picture: see " << said.string() << '\n';
  }
}

int run_demo(const DemoOptions& options) {
  SceneResult found = find_scene(options.scene);
  if (!found) {
    std::cerr << "cs550: " << found.error << '\n';
    return Misused;
  }
  Scene& scene = found.scene;
  scene.settings.audit_momentum = true;

  std::optional<TrajectoryCsv> trajectory;
  if (!options.csv.empty()) trajectory.emplace(options.csv);
  World world = make_world(scene);
  RunRecord record(scene, world);
  const int steps = options.steps > 0 ? options.steps : scene.steps;
  run_scene(world, scene, steps, record, trajectory);
  record.print(std::cout);
  if (options.picture) take_picture(scene, options.scene, steps);
  return record.good() ? Good : Failed;
}

}  // namespace

Action declare_demo(CLI::App& app) {
  const auto options = std::make_shared<DemoOptions>();
  app.add_option("SCENE", options->scene, "name of a shipped scene, or a file")
      ->capture_default_str();
  app.add_option("--csv", options->csv, "write the trajectory to this file");
  app.add_option("--steps", options->steps, "how many steps; the scene's own number if not given")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("!--no-picture", options->picture, "only the summary");
  return [options] { return run_demo(*options); };
}

}  // namespace cs550::cli
