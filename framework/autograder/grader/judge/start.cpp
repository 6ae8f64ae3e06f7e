/// Connects a judge to the submission that the environment names. The main of the judge is that of
/// every graded program.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "autograder/grader/judge/submission.hpp"
#include "autograder/grader/order.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;

/// The libraries of the labs that are not graded, which the submission may call.
std::vector<std::string> other_labs(int lab) {
  std::vector<std::string> libraries;
  if (lab == 0) return libraries;
  for (const fs::path& library : fs::directory_iterator(CS550_LAB_FOLDER)) {
    const std::string name = library.filename().string();
    if (name.ends_with("_reference.so") &&
        name != "liblab" + std::to_string(lab) + "_reference.so") {
      libraries.push_back(library.string());
    }
  }
  return libraries;
}

WorkerSettings settings(const Order& order) {
  WorkerSettings settings;
  settings.per_test = order.wall;
  settings.deadline = order.deadline;
  settings.per_call = std::min<std::chrono::milliseconds>(settings.per_call, order.wall);
  Command& command = settings.command;
  command.isolation = order.isolation;
  command.limits = order.limits;
  command.confines_itself = true;
  command.folder = order.libraries.front().parent_path();
  command.words = {CS550_WORKER_PROGRAM};
  if (order.isolation == Isolation::Plain) command.words.emplace_back("--confine");
  for (const fs::path& library : order.libraries) command.words.push_back(library.string());
  command.words.emplace_back("--");
  command.readable = {CS550_WORKER_PROGRAM, CS550_ENGINE_LIBRARY};
  for (const std::string& library : other_labs(order.lab)) {
    command.words.push_back(library);
    command.readable.emplace_back(library);
  }
  return settings;
}

bool start() {
  const std::optional<Order> order = Order::from_environment();
  if (order) judge(settings(*order));
  return order.has_value();
}

[[maybe_unused]] const bool has_started = start();

}  // namespace
}  // namespace cs550::grader
