#include "engine/threads/thread_trial.hpp"

#include <algorithm>

namespace cs550 {

namespace {

constexpr int steps_of_kind = 3;
constexpr int steps_of_trial = 2 * steps_of_kind;
constexpr int steps_shared = 128;
constexpr int steps_alone = 32;

}  // namespace

bool ThreadTrial::shares_next_step() const {
  if (step_ < steps_of_kind) return true;
  if (step_ < steps_of_trial) return false;
  return shared_ < alone_;
}

/// Leaves out the first step of each kind, which also has to regroup the contacts and to wake the threads.
void ThreadTrial::note(double seconds) {
  if (step_ == 0) shared_ = alone_ = unknown;
  const bool counts = step_ < steps_of_trial && step_ % steps_of_kind > 0;
  if (counts) {
    double& fastest = shares_next_step() ? shared_ : alone_;
    fastest = std::min(fastest, seconds);
  }
  ++step_;
  if (step_ >= steps_of_trial + (shared_ < alone_ ? steps_shared : steps_alone)) step_ = 0;
}

}  // namespace cs550
