#pragma once
/// @file results.hpp
/// The outcome of a run, written as it happens.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace cs550::autograder {

/// Keeps a JSON file up to date with the tests that have run: {points, earned, tests [{test, step,
/// points, earned, status, message, seconds, hidden, long}]}. status is passed, failed, blocked
/// (with blocked_by, the unwritten step) or running; a failed one may have ended_as, crashed or timeout; a test that crashed or was stopped is left as
/// running.
class ResultsWriter : public testing::EmptyTestEventListener {
 public:
  /// @param file the file to write; its folder is made. Empty: only count.
  explicit ResultsWriter(std::filesystem::path file);

  int failed() const { return failed_; }
  int blocked() const { return blocked_; }
  int finished() const { return static_cast<int>(rows_.size()); }

 private:
  void OnTestProgramStart(const testing::UnitTest&) override;
  void OnTestStart(const testing::TestInfo& test) override;
  void OnTestEnd(const testing::TestInfo& test) override;

  void write() const;

  std::filesystem::path file_;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
  int failed_ = 0;
  int blocked_ = 0;
};

}  // namespace cs550::autograder
