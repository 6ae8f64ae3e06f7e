#pragma once
/// @file watch.hpp
/// Whether another program still makes progress.

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

namespace cs550::cli {

/// Reports a file that has not changed for too long: another program writes it as it proceeds.
class Watch {
  using Clock = std::chrono::steady_clock;

 public:
  Watch(std::filesystem::path file, Clock::duration patience)
      : file_(std::move(file)), patience_(patience) {}

  bool is_stuck() {
    std::error_code absent;
    const std::filesystem::file_time_type written = std::filesystem::last_write_time(file_, absent);
    if (!absent && written != written_) {
      written_ = written;
      since_ = Clock::now();
    }
    return Clock::now() - since_ > patience_;
  }

 private:
  std::filesystem::path file_;
  Clock::duration patience_;
  std::filesystem::file_time_type written_;
  Clock::time_point since_ = Clock::now();
};

}  // namespace cs550::cli
