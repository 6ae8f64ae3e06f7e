#include "autograder/grader/grade_lab/options.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "autograder/grader/place.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds longest_compilation{60};

constexpr const char* unprotected =
    "bubblewrap does not work on this machine, and only root can confine a submission without it.\n"
    "A submission could read your files and call the reference. Three ways out:\n"
    "  1. Make bubblewrap work: ./cs550 doctor --install grade. Ubuntu 24.04 also needs an\n"
    "     AppArmor profile, which docs/instructors.md shows.\n"
    "  2. Grade as root, on a machine that holds nothing else.\n"
    "  3. Grade in a container.\n"
    "To grade without protection, add --isolation plain.";

/// Submissions must see no hidden test, and no reference of the lab that is graded.
void check_place() {
  for (const char* place : {CS550_GRADED_TESTS, CS550_LAB_FOLDER}) {
    const fs::path path = fs::weakly_canonical(place);
    if (!is_seen_by_submissions(path)) continue;
    throw std::runtime_error(path.string() +
                             " can be read by every submission,\n"
                             "since it is in a folder of the system, such as /usr.\n"
                             "Move the project and its builds, for example to your home folder.");
  }
  for (const char* folder : seen_by_submissions) {
    const fs::path engine = installed_engine(folder);
    if (engine.empty()) continue;
    throw std::runtime_error(
        engine.string() +
        " can be called by every submission,\n"
        "since it is in a folder of the system. It has the reference of every lab.\n"
        "Remove what cmake --install has put there, and install the engine in\n"
        "another folder, such as /opt/cs550.");
  }
}

}  // namespace

Isolation chosen_isolation(const std::string& wish) {
  const bool is_trusting = wish == "plain" && geteuid() != 0;
  if (!is_trusting) check_place();
  if (wish == "plain") return Isolation::Plain;
  const Isolation best = best_isolation();
  if (best == Isolation::Bubblewrap) return best;
  if (wish == "bubblewrap") throw std::runtime_error("bubblewrap does not work on this machine");
  if (geteuid() != 0) throw std::runtime_error(unprotected);
  return best;
}

fs::path empty_work_folder(const Options& options) {
  const fs::path folder = fs::weakly_canonical(options.work);
  const std::string inside = folder.string() + '/';
  const bool holds_submission =
      (fs::canonical(options.submission).string() + '/').starts_with(inside);
  if (holds_submission || folder == folder.root_path()) {
    throw std::runtime_error("--work " + options.work.string() +
                             " would be emptied, but is in use");
  }
  fs::create_directories(folder);
  for (const fs::path& old : fs::directory_iterator(folder)) fs::remove_all(old);
  fs::create_directory(folder / "run");
  return fs::canonical(folder);
}

Order order_for(const Options& options) {
  Order order;
  order.isolation = chosen_isolation(options.isolation);
  order.limits.cpu = std::chrono::seconds(options.cpu);
  order.limits.memory = static_cast<std::size_t>(options.memory) << 20U;
  order.limits.processes *= static_cast<std::size_t>(options.jobs);
  order.wall = std::chrono::seconds(options.wall);
  order.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(options.lab_time);
  order.salt = options.salt;
  return order;
}

Limits compiler_limits(const Order& order) {
  Limits limits;
  limits.processes = order.limits.processes;
  limits.cpu = longest_compilation;
  return limits;
}

std::chrono::milliseconds time_left(const Order& order, std::chrono::milliseconds longest) {
  using std::chrono::milliseconds;
  const auto left =
      std::chrono::duration_cast<milliseconds>(order.deadline - std::chrono::steady_clock::now());
  return std::clamp(left, milliseconds(0), longest);
}

}  // namespace cs550::grader
