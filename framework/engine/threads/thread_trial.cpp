#include "engine/threads/thread_trial.hpp"

#include <algorithm>

namespace cs550 {

namespace {

constexpr int steps_of_kind = 3;
constexpr int most_steps_to_next_trial = 128;

}  // namespace

bool ThreadTrial::shares_next_step() const {
  if (step_ < steps_of_kind) return true;
  if (step_ < 2 * steps_of_kind) return false;
  return shared_ < alone_;
}

/// The first step of each kind does not count: it forms the groups of the solver anew, and wakes the threads.
void ThreadTrial::note(double seconds) {
  if (step_ == 0) shared_ = alone_ = unknown;
  const bool counts = step_ < 2 * steps_of_kind && step_ % steps_of_kind > 0;
  if (counts) {
    double& fastest = shares_next_step() ? shared_ : alone_;
    fastest = std::min(fastest, seconds);
  }
  if (++step_ < 2 * steps_of_kind + steps_to_next_trial_) return;
  step_ = 0;
  steps_to_next_trial_ = std::min(2 * steps_to_next_trial_, most_steps_to_next_trial);
}

}  // namespace cs550
