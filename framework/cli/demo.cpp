// ./cs550 demo: a scene through the assembled engine, and a summary of what happened.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "verb.hpp"

namespace cs550::cli {
namespace {

struct DemoOptions {
  std::string scene = "wall";
  std::filesystem::path csv;
  int steps = 0;  ///< 0: as many as the scene asks for
};

int run_demo(const DemoOptions& options) {
  std::cerr << "cs550: the engine cannot run '" << options.scene << "' yet\n";
  return Failed;
}

}  // namespace

Action declare_demo(CLI::App& app) {
  const auto options = std::make_shared<DemoOptions>();
  app.add_option("SCENE", options->scene, "name of a shipped scene, or a file")
      ->capture_default_str();
  app.add_option("--csv", options->csv, "write the trajectory to this file");
  app.add_option("--steps", options->steps, "how many steps; the scene's own number if not given")
      ->check(CLI::PositiveNumber);
  return [options] { return run_demo(*options); };
}

}  // namespace cs550::cli
