#include "gradebook/run/interruption.hpp"

#include <csignal>

namespace cs550::gradebook {
namespace {

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

const std::atomic<bool>& interrupted() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    handle(signal, [](int) { was_interrupted = true; });
  }
  // A handler, not SIG_IGN: programs that we start would inherit that.
  handle(SIGXFSZ, [](int) {});
  return was_interrupted;
}

}  // namespace cs550::gradebook
