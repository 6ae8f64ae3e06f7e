#include "autograder/grader/judge/submission.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cs550/not_implemented.hpp>

#include <algorithm>
#include <cereal/types/string.hpp>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <system_error>

#include "autograder/grader/message.hpp"
#include "autograder/grader/order.hpp"
#include "serialisation/byte_archive.hpp"

namespace cs550::grader {
namespace {

using Clock = std::chrono::steady_clock;
using isolation::Channel;
using std::chrono::milliseconds;

constexpr std::size_t kept_output = 4096;  ///< bytes of what a worker prints
constexpr std::string_view loading = "loading the submission";
constexpr const char* lab_time_is_over = "the time for the whole lab is over";
constexpr int patience = 3;  ///< tests that may wait for as long as a call may take
constexpr milliseconds impatient{1000};

std::unique_ptr<Submission>& only() {
  static std::unique_ptr<Submission> submission;
  return submission;
}

/// Its text was written where the function is.
class RemoteNotImplemented : public NotImplemented {
 public:
  RemoteNotImplemented(const std::string& step, const std::string& function, std::string text)
      : NotImplemented(step.c_str(), function.c_str(), "", 0), text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

[[noreturn]] void throw_not_implemented(serialisation::ByteReader& reply) {
  std::string step;
  std::string function;
  std::string text;
  reply(step, function, text);
  static const std::regex valid(R"(L\d{1,2}\.\d{1,2})");
  if (!std::regex_match(step, valid)) throw cereal::Exception("it names no step");
  throw RemoteNotImplemented(step, readable_text(function, 100), readable_text(text, kept_output));
}

/// Ends the judge: a test without a worker has no verdict. The submission has no part in that.
[[noreturn]] void give_up(const std::system_error& error) {
  std::cerr << "a worker cannot be started: " << error.what() << '\n';
  std::_Exit(cannot_start_worker);
}

/// Ends every worker with its test.
class EndOfTest : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo& /*test*/) override { submission().end_test(); }
};

}  // namespace

Submission& submission() {
  if (only()) return *only();
  std::cerr << "nothing to judge: grade_lab starts this program with a submission\n";
  std::exit(2);
}

void judge(WorkerSettings settings) {
  only() = std::make_unique<Submission>(std::move(settings));
  testing::UnitTest::GetInstance()->listeners().Append(new EndOfTest);
}

void connect(int channel) {
  WorkerSettings settings;
  settings.connected = channel;
  settings.per_test = std::chrono::hours(1);  // the process that started this one limits its time
  only() = std::make_unique<Submission>(std::move(settings));
}

void Submission::start() {
  if (Clock::now() >= settings_.deadline) fail("timeout", lab_time_is_over);
  if (settings_.connected >= 0) {
    channel_ = std::make_unique<Channel>(settings_.connected, longest_message);
  } else {
    try {
      start_worker();
    } catch (const std::system_error& error) {
      give_up(error);
    }
  }
  test_ends_ = std::min(Clock::now() + settings_.per_test, settings_.deadline);
  check(receive(loading), loading);
}

void Submission::start_worker() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  channel_ = std::make_unique<Channel>(ends[0], longest_message);
  channel_->limit_sending(settings_.per_call);
  worker_ = std::make_unique<Process>(settings_.command, kept_output, ends[1]);
  close(ends[1]);
}

void Submission::end_worker() {
  if (worker_) worker_->kill();
}

void Submission::end_test() {
  channel_.reset();
  worker_.reset();
  known_.clear();
  failure_.clear();
}

void Submission::tell(std::uint64_t content, const std::string& message) {
  if (!failure_.empty()) fail(status_, failure_);
  if (!channel_) start();
  if (!channel_->send(message)) fail_closed("a mesh");
  known_.insert(content);
}

std::string Submission::ask(std::string_view function, const std::string& request) {
  if (!failure_.empty()) fail(status_, failure_);
  if (!channel_) start();
  if (channel_->has_input()) fail_malformed(function, "it came before the question");
  if (!channel_->send(request)) fail_closed(function);
  return check(receive(function), function);
}

std::string Submission::check(std::string reply, std::string_view function) {
  if (reply.empty()) fail_malformed(function, "it is empty");
  const auto kind = static_cast<Reply>(reply.front());
  reply.erase(0, 1);
  if (kind == (function == loading ? Reply::Ready : Reply::Returned)) return reply;
  try {
    serialisation::ByteReader reader(reply);
    if (kind == Reply::NotImplemented) throw_not_implemented(reader);
    std::string text;
    reader(text);
    text = readable_text(text, kept_output);
    if (kind == Reply::Threw)
      fail("failed", std::string(function) + " threw an exception: " + text);
    if (kind == Reply::Refused) fail("failed", text);
  } catch (const cereal::Exception& error) {
    fail_malformed(function, error.what());
  }
  fail_malformed(function, "its kind is unknown");
}

std::string Submission::receive(std::string_view function) {
  const milliseconds per_call = late_tests_ < patience ? settings_.per_call : impatient;
  const auto left = std::chrono::duration_cast<milliseconds>(test_ends_ - Clock::now());
  const milliseconds limit = std::clamp(left, milliseconds(0), per_call);
  std::string message;
  switch (channel_->receive(message, limit)) {
    case Channel::Wait::Received:
      return message;
    case Channel::Wait::TooLate:
      fail_late(function, limit < per_call ? settings_.per_test : per_call);
    case Channel::Wait::TooLong:
      fail_malformed(function, "it is longer than 16 MB");
    case Channel::Wait::Closed:
      break;
  }
  fail_closed(function);
}

void Submission::fail(const std::string& status, const std::string& message) {
  if (failure_.empty()) {
    failure_ = message;
    status_ = status;
    testing::Test::RecordProperty("ended_as", status);
    ADD_FAILURE() << message;
  }
  throw testing::AssertionException(
      testing::TestPartResult(testing::TestPartResult::kFatalFailure, nullptr, -1, "reported"));
}

void Submission::fail_closed(std::string_view function) {
  if (!worker_) fail("crashed", "the worker ended in " + std::string(function));
  worker_->wait(milliseconds(200));
  worker_->kill();
  std::string how = worker_->ending();
  if (how.empty()) how = "ended with exit code 0";
  std::string message = "the submission " + how + " in " + std::string(function);
  if (const std::string printed = worker_->output(); !printed.empty()) {
    message += "; it printed:\n" + printed;
  }
  fail("crashed", message);
}

void Submission::fail_late(std::string_view function, milliseconds limit) {
  ++late_tests_;
  end_worker();
  if (Clock::now() >= settings_.deadline) fail("timeout", lab_time_is_over);
  fail("timeout", "no answer from " + std::string(function) + " within " +
                      std::to_string(limit.count() / 1000) + " s (an endless loop?)");
}

void Submission::fail_malformed(std::string_view function, std::string_view why) {
  end_worker();
  fail("failed", "the answer of " + std::string(function) + " is not valid: " + std::string(why));
}

void Submission::fail_not_finite(std::string_view function) {
  fail("failed", "the answer of " + std::string(function) + " contains NaN or infinity");
}

}  // namespace cs550::grader
