#pragma once
/// @file progress_bar.hpp
/// How far a long run has come.

#include <chrono>

namespace cs550::cli {

/// One line on standard error that changes in place. Nothing is shown where standard error is no
/// terminal, or before the run has lasted half a second.
class ProgressBar {
 public:
  explicit ProgressBar(int total) : total_(total) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param done so many of the total
  void show(int done);

 private:
  using Clock = std::chrono::steady_clock;
  int total_;
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(500);
  bool visible_ = false;
};

}  // namespace cs550::cli
