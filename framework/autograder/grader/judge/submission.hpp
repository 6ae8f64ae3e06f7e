#pragma once
/// @file submission.hpp
/// The submission that a judge's lab functions ask, in a worker process of its own.

#include <chrono>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "autograder/grader/sandbox.hpp"
#include "isolation/channel.hpp"

namespace cs550::grader {

/// How a worker is started, and how long it may take.
struct WorkerSettings {
  Command command;     ///< the worker, in its sandbox
  int connected = -1;  ///< the channel to a worker that another process has started; else -1
  std::chrono::milliseconds per_call{5000};
  std::chrono::milliseconds per_test{60000};
  /// No test is answered from then on.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// A running worker. It has a new one for every test, so that no test depends on an earlier one.
/// Whatever goes wrong is reported as the failure of the running test, which then ends: a test
/// cannot pass once its worker has failed, even if given code were to catch the exception.
class Submission {
 public:
  explicit Submission(WorkerSettings settings) : settings_(std::move(settings)) {}

  /// Ends the worker, and with it everything that it may have started.
  void end_test();

  /// Whether the worker has been sent a shape or mesh, by its hash.
  bool knows(std::uint64_t content) const { return known_.count(content) != 0; }
  void tell(std::uint64_t content, const std::string& message);
  /// @return the bytes of the answer. @throws NotImplemented if that is the answer
  std::string ask(std::string_view function, const std::string& request);

  [[noreturn]] void fail_malformed(std::string_view function, std::string_view why);
  [[noreturn]] void fail_not_finite(std::string_view function);

 private:
  void start();
  void start_worker();
  void end_worker();
  std::string receive(std::string_view function);
  std::string check(std::string reply, std::string_view function);
  [[noreturn]] void fail(const std::string& status, const std::string& message);
  [[noreturn]] void fail_closed(std::string_view function);
  [[noreturn]] void fail_late(std::string_view function, std::chrono::milliseconds limit);

  WorkerSettings settings_;
  std::unique_ptr<isolation::Channel> channel_;
  std::unique_ptr<Process> worker_;
  std::set<std::uint64_t> known_;
  std::chrono::steady_clock::time_point test_ends_;
  std::string failure_;  ///< of this test
  std::string status_;   ///< "crashed", "timeout" or "failed", with the failure
  int late_tests_ = 0;
};

/// The only one of this program.
Submission& submission();
/// Makes it. To be called once, before the first test.
void judge(WorkerSettings settings);
/// Makes it, with one worker for all tests, which another process has started.
void connect(int channel);

}  // namespace cs550::grader
