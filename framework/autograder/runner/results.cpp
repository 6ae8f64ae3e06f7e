#include "results.hpp"

#include <cs550/graded_test.hpp>
#include <cs550/test_report.hpp>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "files/output_file.hpp"

namespace cs550::autograder {
namespace {

using Json = nlohmann::ordered_json;

GradedTestInfo graded_info(const testing::TestInfo& test) {
  for (const GradedTestInfo& info : graded_tests()) {
    if (info.suite == test.test_suite_name() && info.name == test.name()) {
      return info;
    }
  }
  return {};
}

std::string status(const testing::TestResult& result) {
  if (result.Failed()) {
    return "failed";
  }
  return result.Skipped() ? "blocked" : "passed";
}

/// Its failed checks, in one block, and all other reasons.
std::string message() {
  std::string text = summary(failed_checks());
  for (const std::string& other : other_failures()) text += other + '\n';
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// What the test recorded under a name; empty if nothing.
std::string recorded(const testing::TestResult& result, const std::string& name) {
  for (int i = 0; i < result.test_property_count(); ++i) {
    if (result.GetTestProperty(i).key() == name) return result.GetTestProperty(i).value();
  }
  return {};
}

}  // namespace

ResultsWriter::ResultsWriter(std::filesystem::path file) : file_(std::move(file)) {}

void ResultsWriter::OnTestProgramStart(const testing::UnitTest&) { write(); }

void ResultsWriter::OnTestStart(const testing::TestInfo& test) {
  note_case({});
  const GradedTestInfo info = graded_info(test);
  rows_.push_back({{"test", std::string(test.test_suite_name()) + "." + test.name()},
                   {"step", info.step},
                   {"points", info.points},
                   {"earned", 0},
                   {"status", "running"},
                   {"message", ""},
                   {"seconds", 0.0},
                   {"hidden", info.hidden()},
                   {"long", info.duration == Duration::Long}});
  write();
}

void ResultsWriter::OnTestEnd(const testing::TestInfo& test) {
  const testing::TestResult& result = *test.result();
  Json& row = rows_.back();
  row["status"] = status(result);
  row["message"] = message();
  if (row["status"] == "blocked") row["blocked_by"] = recorded(result, "blocked_by");
  const std::string ended_as = recorded(result, "ended_as");
  if (row["status"] == "failed" && !ended_as.empty()) row["ended_as"] = ended_as;
  row["seconds"] = static_cast<double>(result.elapsed_time()) / 1000.0;
  if (row["status"] == "passed") {
    row["earned"] = row["points"];
  }
  failed_ += row["status"] == "failed";
  blocked_ += row["status"] == "blocked";
  write();
}

void ResultsWriter::write() const {
  if (file_.empty()) {
    return;
  }
  int points = 0;
  int earned = 0;
  for (const Json& row : rows_) {
    points += row["points"].get<int>();
    earned += row["earned"].get<int>();
  }
  const Json document = {{"points", points}, {"earned", earned}, {"tests", rows_}};

  try {
    files::write_file(file_, document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  } catch (const std::runtime_error& error) {
    std::cerr << error.what() << '\n';
    std::exit(2);
  }
}

}  // namespace cs550::autograder
