#pragma once
/// @file record.hpp
/// Recorded tracks, framework/assets/trajectories/*.csv, and how a run differs from one.

#include <filesystem>
#include <string>
#include <vector>

#include "milestone.hpp"

namespace cs550::milestones {

/// A table: the names of its columns, the first of them the time (s), and a row for each look.
struct Record {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// Where the record of a milestone is.
std::filesystem::path record_file(const Milestone& milestone);

Record to_record(const Track& track);

/// As CSV with six significant digits; semicolons between them, since names hold commas.
std::string to_csv(const Record& record);

/// Throws std::runtime_error when there is no such table.
Record read_record(const std::filesystem::path& file);

/// How a run compares with a record.
struct Comparison {
  bool agrees = false;
  double until = 0;      ///< how long it agrees (s)
  std::string sentence;  ///< for people: where it departs first and by how much, or how close it is
};

/// @param share of the tolerances that is allowed
Comparison compare(const Track& track, const Record& record, double share = 1);

}  // namespace cs550::milestones
