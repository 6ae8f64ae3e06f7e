#pragma once
/// @file order.hpp
/// What grade_lab asks of a judge, passed in the environment.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "autograder/grader/sandbox.hpp"

namespace cs550::grader {

/// Exit code of a judge on a machine that cannot start a worker; EX_OSERR of sysexits.h.
inline constexpr int cannot_start_worker = 71;

struct Order {
  /// 0: all labs together, as one engine.
  int lab = 0;
  /// The compiled submission, absolute paths in one folder: a library of the lab, or one of each lab.
  std::vector<std::filesystem::path> libraries;
  Isolation isolation = Isolation::Plain;
  Limits limits;                  ///< of each worker
  std::chrono::seconds wall{60};  ///< longest time for one test
  /// When the time for the whole lab is over, from its compilation to its last test.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  std::uint32_t salt = 0;  ///< of the seeds; it reaches the tests by CS550_SEED_SALT

  /// "NAME=value" for the environment of a judge.
  std::string to_environment() const;
  /// Empty if there is none.
  static std::optional<Order> from_environment();
};

}  // namespace cs550::grader
