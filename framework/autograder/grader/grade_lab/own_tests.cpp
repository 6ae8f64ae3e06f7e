#include "autograder/grader/grade_lab/own_tests.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "autograder/grader/grade_lab/compile.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds longest_run{20};
constexpr std::size_t kept_output = 4096;  // bytes
/// So many runs on the reference for each mistake, and no fewer than `fewest`: tests that fail at random
/// must fail on the reference, too.
constexpr double reference_share = 0.5;
constexpr std::size_t fewest = 5;

/// The libraries of known mistakes in a lab, which tests/mutants/build_libraries.py has made.
std::vector<fs::path> mistakes_of(int lab) {
  const fs::path folder = fs::path(CS550_MISTAKES) / ("lab" + std::to_string(lab));
  std::vector<fs::path> libraries;
  std::error_code absent;
  for (const fs::path& file : fs::directory_iterator(folder, absent)) {
    if (file.extension() == ".so") libraries.push_back(file);
  }
  if (libraries.empty()) {
    throw std::runtime_error(folder.string() +
                             " has no known mistakes; build them: ./cs550 build test mistakes");
  }
  std::sort(libraries.begin(), libraries.end());
  return libraries;
}

struct Run {
  std::string failure;  ///< what the tests print if they fail; empty if they pass
  bool stopped = false;
};

/// Runs compiled tests on libraries of their lab.
class Runner {
 public:
  Runner(const Order& order, fs::path tests) : order_(order), tests_(std::move(tests)) {}

  Run run(const fs::path& library, unsigned seed) const {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      throw std::system_error(errno, std::generic_category(), "socketpair");
    }
    Process worker(worker_command(library), kept_output, ends[0]);
    Process tests(tests_command(seed), kept_output, ends[1]);
    close(ends[0]);
    close(ends[1]);
    const bool in_time = tests.wait(time_left(order_, longest_run));
    tests.kill();
    worker.kill();
    if (!in_time) {
      return {
          "it does not end within " + std::to_string(longest_run.count()) + " s\n" + tests.output(),
          true};
    }
    return {tests.succeeded() ? "" : tests.output() + '\n' + tests.ending()};
  }

  fs::path reference() const { return library("reference", order_.lab); }

 private:
  static fs::path library(const std::string& variant, int lab) {
    return fs::path(CS550_LAB_FOLDER) / ("liblab" + std::to_string(lab) + '_' + variant + ".so");
  }

  std::vector<fs::path> other_references() const {
    std::vector<fs::path> libraries;
    for (int lab = 1; fs::exists(library("reference", lab)); ++lab) {
      if (lab != order_.lab) libraries.push_back(library("reference", lab));
    }
    return libraries;
  }

  Command sandbox(const fs::path& program, const fs::path& folder) const {
    Command command;
    command.isolation = order_.isolation;
    command.limits = order_.limits;
    command.limits.cpu = longest_run;
    command.confines_itself = true;
    command.folder = folder;
    command.words = {program.string()};
    if (order_.isolation == Isolation::Plain) command.words.emplace_back("--confine");
    command.readable = other_references();
    command.readable.insert(command.readable.end(), {program, fs::path(CS550_ENGINE_LIBRARY)});
    return command;
  }

  Command worker_command(const fs::path& library) const {
    Command command = sandbox(CS550_WORKER_PROGRAM, library.parent_path());
    command.words.insert(command.words.end(), {library.string(), "--"});
    for (const fs::path& other : other_references()) command.words.push_back(other.string());
    return command;
  }

  /// Not the lab's reference: tests could compare its answers with those that they get.
  Command tests_command(unsigned seed) const {
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() /
                             ("lab" + std::to_string(order_.lab) + "_own_tests");
    Command command = sandbox(program, tests_.parent_path());
    command.words.insert(command.words.end(), {tests_.string(), std::to_string(seed)});
    command.readable.push_back(library("remote", order_.lab));
    return command;
  }

  const Order& order_;
  fs::path tests_;
};

}  // namespace

Json grade_own_tests(const Options& options, const std::string& lab_name) {
  const fs::path work = empty_work_folder(options);
  Order order = order_for(options);
  order.lab = options.lab;
  const fs::path tests = work / "run" / "my_tests.so";
  const Compilation compilation =
      compile(options.submission, lab_name, tests, order, Part::OwnTests);
  const Runner runner(order, tests);
  std::vector<fs::path> libraries = mistakes_of(options.lab);
  const std::size_t mistakes = libraries.size();
  const auto share = static_cast<std::size_t>(reference_share * static_cast<double>(mistakes));
  libraries.resize(mistakes + std::max(fewest, share), runner.reference());
  std::mt19937 random(std::random_device{}());
  std::shuffle(libraries.begin(), libraries.end(), random);

  Json record{{"lab", options.lab},
              {"isolation", to_string(order.isolation)},
              {"compiled", compilation.succeeded},
              {"stopped", compilation.was_stopped},
              {"message", compilation.errors},
              {"mistakes", mistakes},
              {"caught", 0},
              {"reference_runs", libraries.size() - mistakes},
              {"reference_failures", 0}};
  if (!compilation.succeeded) return record;
  std::size_t caught = 0;
  for (const fs::path& library : libraries) {
    constexpr unsigned most_seeds = 99999;  // GoogleTest's
    const Run run = runner.run(library, 1 + random() % most_seeds);
    if (time_left(order, longest_run).count() == 0) {
      record["stopped"] = true;
      record["reference_failures"] = 1;  // some runs on the reference may be missing
      record["message"] =
          "its runs together take longer than " + std::to_string(options.lab_time) + " s";
      return record;
    }
    if (run.failure.empty()) continue;
    if (library == runner.reference()) {
      record["stopped"] = run.stopped;
      record["reference_failures"] = 1;
      record["message"] =
          "it fails on the reference:\n" + readable_text(run.failure, kept_output - 64);
      return record;
    }
    ++caught;
  }
  record["caught"] = caught;
  return record;
}

}  // namespace cs550::grader
