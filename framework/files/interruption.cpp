#include "files/interruption.hpp"

#include <csignal>
#include <stdexcept>

namespace cs550::files {
namespace {

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

}  // namespace

void watch_for_interruption(SecondSignal second) {
  struct sigaction action {};
  action.sa_handler = [](int) { was_interrupted = true; };
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  if (second == SecondSignal::Ends) action.sa_flags |= static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  struct sigaction inherited {};
  sigaction(SIGHUP, nullptr, &inherited);
  if (inherited.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

const std::atomic<bool>& interrupted() { return was_interrupted; }

void throw_if_interrupted() {
  if (was_interrupted) throw std::runtime_error("interrupted: what was unfinished is removed");
}

}  // namespace cs550::files
