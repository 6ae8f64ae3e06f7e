#pragma once
/// @file order.hpp
/// What grade_lab asks of a judge, passed in the environment.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "autograder/grader/sandbox.hpp"

namespace cs550::grader {

struct Order {
  int lab = 0;
  std::filesystem::path submission;  ///< the compiled library, absolute
  Isolation isolation = Isolation::Plain;
  Limits limits;                  ///< of each worker
  std::chrono::seconds wall{60};  ///< longest time for one test
  std::uint32_t salt = 0;         ///< of the seeds; it reaches the tests by CS550_SEED_SALT

  /// "NAME=value" for the environment of a judge.
  std::string to_environment() const;
  /// Empty if there is none.
  static std::optional<Order> from_environment();
};

}  // namespace cs550::grader
