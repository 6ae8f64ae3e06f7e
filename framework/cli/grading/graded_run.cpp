#include "cli/grading/graded_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <functional>
#include <future>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <system_error>
#include <thread>

#include "cli/grading/crash_report.hpp"
#include "cli/grading/debugging.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/system/watch.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// `--gtest_filter=Lab3.A:Lab3.B`
std::string filter(int lab, const std::vector<GradedTest>& tests) {
  std::string filter = "--gtest_filter=";
  for (const GradedTest& test : tests) {
    filter += "Lab" + std::to_string(lab) + '.' + test.name + ':';
  }
  return filter;
}

/// The rows of the results file, by the name of the test.
std::map<std::string, Json> read_results(const fs::path& file) {
  std::map<std::string, Json> rows;
  std::ifstream stream(file);
  if (!stream) return rows;
  const Json document = Json::parse(stream, nullptr, false);
  if (document.is_discarded()) return rows;
  for (const Json& row : document.at("tests")) {
    const std::string name = row.at("test");
    rows[name.substr(name.find('.') + 1)] = row;
  }
  return rows;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Verdict to_verdict(const GradedTest& test, const Json& row) {
  return {test, verdict_kind(row.at("status")), row.at("message"), row.at("seconds"),
          row.value("blocked_by", "")};
}

/// The files that a graded program writes.
struct Outputs {
  fs::path results;       ///< JSON, up to date whatever happens to the program
  fs::path running_case;  ///< what the running test described last, padded with zeros
  fs::path printed;

  explicit Outputs(const std::string& draft)
      : results(draft + ".json"), running_case(draft + ".json.case"), printed(draft + ".txt") {}
  void remove() const {
    for (const fs::path& file : {results, running_case, printed}) fs::remove(file);
  }
};

/// What to try when a test has no verdict of its own.
std::string advice(int lab, const Ending& ending) {
  return ending.printed_too_much()
             ? fmt::format("try  ./cs550 lab {} --debug  {}\n", lab, how_to_find_a_loop)
             : fmt::format("try  ./cs550 lab {} --asan  which prints the line\n", lab);
}

/// How the program ended, what to try, and in which case.
Verdict ended_the_program(int lab, const GradedTest& test, const Ending& ending,
                          const Outputs& outputs) {
  const std::string report = crash_report(read_output(outputs.printed, ending));
  std::string running_case = text_of(outputs.running_case);
  running_case.erase(std::min(running_case.find('\0'), running_case.size()));
  // A sanitizer ends the program by itself: its report is more useful than the exit code.
  const bool sanitizer = !report.empty() && ending.signal == 0;
  std::string how = ending.in_words() + '\n' + report + advice(lab, ending);
  if (sanitizer) how = ending.stopped ? ending.in_words() + '\n' + calls_in(report) : report;
  return {test, Verdict::Kind::Failed, how + running_case, 0, "", how.substr(0, how.find('\n'))};
}

std::vector<Verdict> in_order_of(const std::vector<GradedTest>& tests,
                                 const std::vector<Verdict>& verdicts) {
  std::vector<Verdict> ordered;
  ordered.reserve(tests.size());
  for (const GradedTest& test : tests) {
    ordered.push_back(*std::find_if(verdicts.begin(), verdicts.end(), [&](const Verdict& verdict) {
      return verdict.test.name == test.name;
    }));
  }
  return ordered;
}

std::size_t processors() { return std::max(1U, std::thread::hardware_concurrency()); }

/// Deals the tests out like cards: neighbours, which often take equally long, go to different
/// hands. No hand is empty.
std::vector<std::vector<GradedTest>> deal(const std::vector<GradedTest>& tests, std::size_t hands) {
  std::vector<std::vector<GradedTest>> shares(std::min(hands, tests.size()));
  for (std::size_t i = 0; i < tests.size(); ++i) shares[i % hands].push_back(tests[i]);
  return shares;
}

/// Runs tests one after the other. When one ends the program, that is its verdict, and the program
/// is started again for the tests after it.
/// @param finished how many tests no longer have a row in the outputs; increased
std::vector<Verdict> run_share(const fs::path& program, int lab,
                               const std::vector<GradedTest>& tests, std::chrono::seconds patience,
                               const Limits& limits, const Outputs& outputs,
                               std::atomic<std::size_t>& finished) {
  std::vector<Verdict> verdicts;
  std::vector<GradedTest> waiting = tests;
  outputs.remove();
  while (!waiting.empty()) {
    Watch watch(outputs.results, patience);  // written at the start and at the end of each test
    const Ending ending =
        run({program, filter(lab, waiting), "--results", outputs.results},
            {project_root(), outputs.printed, [&] { return watch.is_stuck(); }, limits, SIGABRT});

    const std::map<std::string, Json> rows = read_results(outputs.results);
    std::vector<GradedTest> not_reached;
    bool one_ended_it = false;
    for (const GradedTest& test : waiting) {
      const auto row = rows.find(test.name);
      if (row == rows.end()) {
        not_reached.push_back(test);
      } else if (row->second.at("status") == "running") {
        verdicts.push_back(ended_the_program(lab, test, ending, outputs));
        one_ended_it = true;
      } else {
        verdicts.push_back(to_verdict(test, row->second));
      }
    }
    if (!one_ended_it) {  // it ended before or after the tests, and would do so again
      for (const GradedTest& test : not_reached) {
        verdicts.push_back(ended_the_program(lab, test, ending, outputs));
      }
      not_reached.clear();
    }
    outputs.remove();
    finished += waiting.size() - not_reached.size();
    waiting = not_reached;
  }
  return verdicts;
}

/// How far the tests have come, and one that is running: two names do not fit into a line.
std::string progress_of(const std::vector<Outputs>& outputs, std::size_t finished,
                        std::size_t count) {
  std::string running;
  for (const Outputs& share : outputs) {
    for (const auto& [name, row] : read_results(share.results)) {
      if (row.at("status") != "running") {
        ++finished;
      } else if (running.empty()) {
        running = ", " + name;
      }
    }
  }
  return fmt::format("Test {} of {}{}", std::min(finished + 1, count), count, running);
}

std::vector<Verdict> wait_for(std::future<std::vector<Verdict>>& share,
                              const std::function<std::string()>& progress) {
  constexpr std::chrono::milliseconds glance{100};
  StatusLine status;
  while (share.wait_for(glance) != std::future_status::ready) status.show(progress);
  return share.get();
}

/// Removes the outputs of runs that were interrupted: lab3.PID.0.json and draft.NAME.PID of a process that is
/// gone.
void remove_leftovers(const fs::path& folder) {
  static const std::regex name(R"((?:lab\d+|draft\.\w+)\.(\d{1,9})(?:\.\d+\..*)?)");
  std::vector<fs::path> leftovers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename();
    std::smatch found;
    if (!std::regex_match(file, found, name)) continue;
    if (kill(std::stoi(found[1]), 0) != 0 && errno == ESRCH) leftovers.push_back(entry.path());
  }
  std::error_code already_removed;
  for (const fs::path& file : leftovers) fs::remove(file, already_removed);
}

}  // namespace

std::vector<Verdict> run_graded_tests(const fs::path& program, int lab,
                                      const std::vector<GradedTest>& tests,
                                      std::chrono::seconds patience, const Arrived& arrived,
                                      const Limits& limits) {
  const fs::path folder = project_root() / "build/results";
  fs::create_directories(folder);
  remove_leftovers(folder);
  const std::string draft = "lab" + std::to_string(lab) + '.' + std::to_string(getpid()) + '.';

  const std::vector<std::vector<GradedTest>> shares = deal(tests, processors());
  std::vector<Outputs> outputs;
  std::atomic<std::size_t> finished = 0;
  std::vector<std::future<std::vector<Verdict>>> runs;
  runs.reserve(shares.size());
  for (const std::vector<GradedTest>& share : shares) {
    outputs.emplace_back((folder / (draft + std::to_string(runs.size()))).string());
    runs.push_back(std::async(std::launch::async, run_share, program, lab, share, patience, limits,
                              outputs.back(), std::ref(finished)));
  }
  const auto progress = [&] {
    return fmt::format("{}, at most {} s", progress_of(outputs, finished, tests.size()),
                       patience.count());
  };
  std::vector<Verdict> verdicts;
  for (std::future<std::vector<Verdict>>& run : runs) {
    const std::vector<Verdict> share = wait_for(run, progress);
    if (arrived) arrived(share);
    verdicts.insert(verdicts.end(), share.begin(), share.end());
  }
  return in_order_of(tests, verdicts);
}

}  // namespace cs550::cli
