#pragma once
/// @file thread_trial.hpp
/// Whether the threads of a world save time.

#include <limits>

namespace cs550 {

/// Compares the time of steps that the threads of a world share with that of steps on one thread. Both leave the
/// same bits, so a clock may decide.
///
/// A trial has three steps of each kind. Until the next trial, steps are of the kind that was faster: 128 steps if
/// the threads have won. If one thread has won, only 32, since something else may have delayed the threads, and a
/// scene often begins with bodies in the air.
class ThreadTrial {
 public:
  /// Whether the threads share the next step.
  bool shares_next_step() const;
  /// @param seconds that this step took
  void note(double seconds);

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  int step_ = 0;             ///< since the trial began
  double shared_ = unknown;  ///< the fastest step of the trial (s)
  double alone_ = unknown;
};

}  // namespace cs550
