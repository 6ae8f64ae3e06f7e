#pragma once
/// @file options.hpp
/// What grade_lab was asked for.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "autograder/grader/order.hpp"

namespace cs550::grader {

struct Options {
  int lab = 0;
  bool milestones = false;
  bool own_tests = false;
  bool challenge = false;
  std::filesystem::path submission;
  std::filesystem::path work;
  std::filesystem::path results;
  std::uint32_t salt = 0;
  std::string filter = "*";
  // A world of hundreds of contacts takes a million calls. An endless loop ends with its call.
  int wall = 1800;
  int cpu = 1800;
  int memory = 2048;
  int lab_time = 600;
  int jobs = 1;
  std::string isolation = "auto";
};

/// @param wish "bubblewrap", "plain", or "auto" for the best that keeps a submission from stealing points
/// @throws std::runtime_error if it does not work here
Isolation chosen_isolation(const std::string& wish);

/// The folder for this run, with nothing in it but the folder run/ for the compiled submission.
/// @throws std::runtime_error if emptying it would delete what is graded, or anything else of value
std::filesystem::path empty_work_folder(const Options& options);

/// Limits, isolation and seeds. @throws std::runtime_error if this isolation does not work here
Order order_for(const Options& options);

/// Of a compilation: a minute and 2 GB, whatever the tests may take.
Limits compiler_limits(const Order& order);

/// At most `longest`, and no longer than until the lab's deadline.
std::chrono::milliseconds time_left(const Order& order, std::chrono::milliseconds longest);

}  // namespace cs550::grader
