#include "graded_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "crash_report.hpp"
#include "process.hpp"
#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

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
  return {test, verdict_kind(row.at("status")), row.at("message"), row.at("seconds")};
}

Verdict ended_the_program(const GradedTest& test, const Ending& ending, const fs::path& output) {
  const std::string report = crash_report(text_of(output));
  // A sanitizer ends the program by itself: how is no news.
  const bool sanitizer = !report.empty() && ending.signal == 0 && !ending.stopped;
  return {test, Verdict::Kind::Failed, sanitizer ? report : ending.in_words() + '\n' + report, 0};
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

/// Notices when a file has not changed for too long: the graded program writes it at the start and
/// at the end of each test.
class Watch {
 public:
  Watch(fs::path file, Clock::duration patience) : file_(std::move(file)), patience_(patience) {}

  bool stands_still() {
    std::error_code absent;
    const fs::file_time_type written = fs::last_write_time(file_, absent);
    if (!absent && written != written_) {
      written_ = written;
      since_ = Clock::now();
    }
    return Clock::now() - since_ > patience_;
  }

 private:
  fs::path file_;
  Clock::duration patience_;
  fs::file_time_type written_;
  Clock::time_point since_ = Clock::now();
};

std::size_t processors() { return std::max(1U, std::thread::hardware_concurrency()); }

/// As cards are dealt: neighbours, which often cost alike, go to different hands. No hand is empty.
std::vector<std::vector<GradedTest>> deal(const std::vector<GradedTest>& tests, std::size_t hands) {
  std::vector<std::vector<GradedTest>> shares(std::min(hands, tests.size()));
  for (std::size_t i = 0; i < tests.size(); ++i) shares[i % hands].push_back(tests[i]);
  return shares;
}

/// Runs tests one after the other. When one ends the program, that is its verdict, and the program
/// is started again for those after it.
/// @param draft beginning of the names of files to write to meanwhile
std::vector<Verdict> run_share(const fs::path& program, int lab,
                               const std::vector<GradedTest>& tests, std::chrono::seconds patience,
                               const fs::path& draft) {
  const fs::path results = draft.string() + ".json";
  const fs::path output = draft.string() + ".txt";

  std::vector<Verdict> verdicts;
  std::vector<GradedTest> waiting = tests;
  while (!waiting.empty()) {
    fs::remove(results);
    Watch watch(results, patience);
    const Ending ending = run({program, filter(lab, waiting), "--results", results},
                              {project_root(), output, [&] { return watch.stands_still(); }});

    const std::map<std::string, Json> rows = read_results(results);
    std::vector<GradedTest> not_reached;
    bool one_ended_it = false;
    for (const GradedTest& test : waiting) {
      const auto row = rows.find(test.name);
      if (row == rows.end()) {
        not_reached.push_back(test);
      } else if (row->second.at("status") == "running") {
        verdicts.push_back(ended_the_program(test, ending, output));
        one_ended_it = true;
      } else {
        verdicts.push_back(to_verdict(test, row->second));
      }
    }
    if (!one_ended_it) {  // the code did it before or after the tests: it would do so again
      for (const GradedTest& test : not_reached) {
        verdicts.push_back(ended_the_program(test, ending, output));
      }
      not_reached.clear();
    }
    waiting = not_reached;
  }
  fs::remove(results);
  fs::remove(output);
  return verdicts;
}

}  // namespace

std::vector<Verdict> run_graded_tests(const fs::path& program, int lab,
                                      const std::vector<GradedTest>& tests,
                                      std::chrono::seconds patience) {
  const fs::path folder = project_root() / "build/results";
  fs::create_directories(folder);
  const std::string draft = "lab" + std::to_string(lab) + '.' + std::to_string(getpid()) + '.';

  const std::vector<std::vector<GradedTest>> shares = deal(tests, processors());
  std::vector<std::future<std::vector<Verdict>>> runs;
  runs.reserve(shares.size());
  for (const std::vector<GradedTest>& share : shares) {
    runs.push_back(std::async(std::launch::async, run_share, program, lab, share, patience,
                              folder / (draft + std::to_string(runs.size()))));
  }
  std::vector<Verdict> verdicts;
  for (std::future<std::vector<Verdict>>& run : runs) {
    const std::vector<Verdict> share = run.get();
    verdicts.insert(verdicts.end(), share.begin(), share.end());
  }
  return in_order_of(tests, verdicts);
}

}  // namespace cs550::cli
