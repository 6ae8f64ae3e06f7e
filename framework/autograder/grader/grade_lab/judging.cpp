#include "autograder/grader/grade_lab/judging.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "files/interruption.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr rlim_t most_memory = rlim_t{8} << 30U;  ///< of a judge: it may be given enormous answers
constexpr std::chrono::seconds own_time{30};      ///< for a test, beside what the submission takes
/// Exit code of a judge that no test matches, that is not told what to judge, or that cannot write results.
constexpr int wrong_usage = 2;
/// Exit code in place of a program that could not be started.
constexpr int cannot_start = 127;

fs::path judge_program(int lab) {
  const std::string what = lab == 0 ? "milestones" : "lab" + std::to_string(lab);
  return fs::read_symlink("/proc/self/exe").parent_path() / (what + "_judge");
}

/// Reports a judge that has written nothing for too long: it writes at the start and the end of each
/// test. Its checks may loop for ever over what a submission returned. After the lab's deadline no test
/// waits for the submission.
class Watch {
 public:
  Watch(fs::path results, const Order& order)
      : results_(std::move(results)), patience_(order.wall + own_time), deadline_(order.deadline) {}

  bool is_stuck() {
    std::error_code absent;
    const fs::file_time_type written = fs::last_write_time(results_, absent);
    if (!absent && written != written_) {
      written_ = written;
      since_ = Clock::now();
    }
    const Clock::duration quiet = Clock::now() - since_;
    return quiet > patience_ || (Clock::now() > deadline_ && quiet > own_time);
  }

 private:
  fs::path results_;
  std::chrono::seconds patience_;
  Clock::time_point deadline_;
  fs::file_time_type written_;
  Clock::time_point since_ = Clock::now();
};

/// Runs a program of ours to its end, with its output in a file.
/// @return its exit code; 0 if a signal ended it
int run(const std::vector<std::string>& words, const std::vector<std::string>& environment,
        const fs::path& folder, const fs::path& output, Watch watch) {
  const std::vector<char*> arguments = pointers(words);
  const std::vector<char*> variables = pointers(environment);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit memory{most_memory, most_memory};
    setrlimit(RLIMIT_AS, &memory);
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execve(arguments[0], arguments.data(), variables.data());
    _exit(cannot_start);
  }
  int status = 0;
  while (waitpid(child, &status, WNOHANG) != child) {
    if (watch.is_stuck() || files::interrupted()) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  kill_orphans();  // the worker of a judge that was killed
  files::throw_if_interrupted();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 0;
}

/// Whether a judge ended in a way to which no answer of a submission can lead.
bool is_machines_failure(int exit_code) {
  return exit_code == wrong_usage || exit_code == cannot_start || exit_code == cannot_start_worker;
}

/// What a judge has printed last.
std::string last_line(const fs::path& output) {
  std::ifstream stream(output);
  std::string last;
  for (std::string line; std::getline(stream, line);) last = line;
  constexpr std::size_t longest = 500;  // bytes
  return readable_text(last, longest);
}

[[noreturn]] void throw_failure(int lab, int exit_code, const fs::path& output) {
  const std::string how =
      exit_code == 0 ? " was stopped" : " ended with exit code " + std::to_string(exit_code);
  throw std::runtime_error(judge_program(lab).filename().string() + how + ": " + last_line(output));
}

Json read_json(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

std::vector<std::string> judge_environment(const Order& order, const fs::path& work,
                                           std::uint32_t salt) {
  return {order.to_environment(), "CS550_PICTURES=" + (work / "pictures").string(),
          "CS550_SEED_SALT=" + std::to_string(salt)};
}

}  // namespace

Json run_judge(const Order& order, std::size_t tests, const std::string& filter,
               const fs::path& work) {
  const std::string suite = order.lab == 0 ? "Milestone." : "Lab" + std::to_string(order.lab) + ".";
  const std::vector<std::string> environment = judge_environment(order, work, order.salt);
  if (!fs::exists(judge_program(order.lab))) {
    throw std::runtime_error(judge_program(order.lab).string() +
                             " is missing; build it: ./cs550 build test judges");
  }
  const std::string leave_out =
      "--gtest_filter=" + filter + (filter.find('-') == std::string::npos ? "-" : ":");
  const bool may_be_fewer = order.lab != 0 && filter != "*";
  const fs::path log = work / "judge.log";
  Json rows = Json::object();
  while (rows.size() < tests) {
    const fs::path results = work / "judge.json";
    fs::remove(results);
    std::string ended;  // tests that have a verdict
    for (const auto& [name, row] : rows.items()) {
      if (!ended.empty()) ended += ':';
      ended.append(suite).append(name);
    }
    const int exit_code =
        run({judge_program(order.lab).string(), "--results", results.string(), leave_out + ended},
            environment, work, log, Watch(results, order));
    const Json document = read_json(results);
    const bool has_begun = !document.is_discarded() && !document.at("tests").empty();
    if (!has_begun && may_be_fewer && !rows.empty()) break;
    if (!has_begun || is_machines_failure(exit_code)) throw_failure(order.lab, exit_code, log);
    for (const Json& row : document.at("tests")) {
      rows[row.at("test").get<std::string>().substr(suite.size())] = row;
    }
  }
  return rows;
}

Json run_challenge(const Order& order, const fs::path& work) {
  constexpr std::uint32_t published_seeds = 0;
  const fs::path counts = work / "challenge.json";
  const int exit_code =
      run({judge_program(order.lab).string(), "--challenge"},
          judge_environment(order, work, published_seeds), work, counts, Watch(counts, order));
  if (is_machines_failure(exit_code)) throw_failure(order.lab, exit_code, counts);
  const Json rows = read_json(counts);
  return rows.is_array() ? rows : Json::array();
}

}  // namespace cs550::grader
