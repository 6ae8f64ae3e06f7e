// Runs the milestones on the labs that this program is linked with, and compares them with the
// records.
#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

#include "files/output_file.hpp"
#include "milestones/record.hpp"

namespace {

using namespace cs550;
using namespace cs550::milestones;

Scene scene_of(const Milestone& milestone) {
  SceneResult found = find_scene(milestone.scene);
  if (!found) throw std::runtime_error(found.error);
  return found.scene;
}

/// Prints `lab4_ghosts: Four shapes fly ...`, then the result.
bool show(const Milestone& milestone, double share, const std::function<void()>& stepped) {
  std::cout << milestone.name() << std::flush;
  Comparison outcome;
  try {
    const Scene scene = scene_of(milestone);
    std::cout << ": " << scene.title << std::flush;
    outcome = compare(run(milestone, scene, stepped), read_record(record_file(milestone)), share);
  } catch (const std::bad_alloc&) {
    outcome.sentence = "it allocated too much memory (a loop that adds elements without end?)";
  } catch (const std::exception& missing) {
    outcome.sentence = missing.what();
  }
  std::cout << '\n' << (outcome.agrees ? "reached: " : "not reached: ") << outcome.sentence << '\n';
  if (!outcome.agrees) {
    std::cout << "To watch it: " << command_to_watch(milestone) << '\n';
  }
  return outcome.agrees;
}

void update_record(const Milestone& milestone) {
  const Track track = run(milestone, scene_of(milestone));
  if (!track.problem.empty()) throw std::runtime_error(milestone.name() + ": " + track.problem);
  files::write_file(record_file(milestone), to_csv(to_record(track)));
  std::cout << "Wrote " << record_file(milestone).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Compares the scenes that each lab adds to the assembled engine with the recorded reference");
  int lab = 0;
  bool update = false;
  double share = 1;
  std::filesystem::path pulse;
  app.add_option("--lab", lab, "run this lab's milestones only");
  app.add_flag("--update", update, "record the reference again");
  app.add_option("--share", share, "share of the tolerances that may be used, from 0 to 1");
  app.add_option("--pulse", pulse, "write this file anew after each step of the engine");
  CLI11_PARSE(app, argc, argv);
  const auto stepped = [&pulse] {
    if (!pulse.empty()) std::ofstream(pulse) << '.';
  };
  try {
    const std::vector<Milestone> milestones = lab > 0 ? milestones_of(lab) : all_milestones();
    if (milestones.empty()) std::cout << "Lab " << lab << " has no milestone.\n";
    bool all_reached = true;
    for (const Milestone& milestone : milestones) {
      if (update) {
        update_record(milestone);
      } else {
        all_reached = show(milestone, share, stepped) && all_reached;
      }
    }
    files::check_standard_output();
    return all_reached ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
