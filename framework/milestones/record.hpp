#pragma once
/// @file record.hpp
/// Recorded runs of the reference, framework/assets/trajectories/*.csv, and comparing a run with
/// one.

#include <filesystem>
#include <string>
#include <vector>

#include "milestone.hpp"

namespace cs550::milestones {

/// A table: the names of its columns, and a row for each observation. The first column is the time
/// (s).
struct Record {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// The file of a milestone's record.
std::filesystem::path record_file(const Milestone& milestone);

Record to_record(const Track& track);

/// As CSV with six significant digits, separated by semicolons, since names contain commas.
std::string to_csv(const Record& record);

/// Throws std::runtime_error when the file is not such a table.
Record read_record(const std::filesystem::path& file);

/// How a run compares with a record.
struct Comparison {
  bool agrees = false;
  double until = 0;      ///< how long it agrees (s)
  std::string sentence;  ///< for people: the first difference, or the largest one within tolerance
};

/// @param share of the tolerances that may be used
Comparison compare(const Track& track, const Record& record, double share = 1);

}  // namespace cs550::milestones
