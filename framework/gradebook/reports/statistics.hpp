#pragma once
/// @file statistics.hpp
/// What the marks of a class say about its labs, tests and students.

#include <string>
#include <vector>

#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// The spread of a lab's marks, in per cent of its points, over those who submitted it.
struct LabStatistics {
  int lab = 0;
  int submissions = 0;
  int missing = 0;
  int not_compiled = 0;
  double mean = 0;
  double median = 0;
  std::vector<int> histogram;  ///< ten bins of 10 %; 100 % is in the last
};

struct TestStatistics {
  std::string name;
  std::string step;
  bool hidden = false;
  int passed = 0;
  int submissions = 0;
  /// Correlation of passing this test with the points of the lab's other tests (corrected
  /// item-total correlation, Nunnally 1978). Near 0 or negative: the test does not tell good work
  /// from bad.
  double discrimination = 0;
  bool discriminates = false;  ///< whether the correlation is defined: both vary
};

/// How many students' engines reach a milestone.
struct MilestoneStatistics {
  std::string name;
  int reached = 0;
  int engines = 0;
};

/// Submissions that fail a test with the same message, numbers aside.
struct AlikeFailures {
  std::string test;
  std::string message;  ///< the first line, with numbers as #; not that of a hidden test
  std::vector<const StudentMark*> students;
};

/// Students who submitted the same files for a lab.
struct EqualFiles {
  int lab = 0;
  std::vector<const StudentMark*> students;
};

struct Outlier {
  const StudentMark* student = nullptr;
  std::string why;
};

struct ClassStatistics {
  std::vector<LabStatistics> labs;
  std::vector<TestStatistics> tests;
  std::vector<MilestoneStatistics> milestones;  ///< in order; empty if none were run
  std::vector<AlikeFailures> failures;  ///< the largest groups first; groups of at least two
  std::vector<EqualFiles> equal;
  std::vector<Outlier> outliers;
};

ClassStatistics statistics_of(const std::vector<StudentMark>& marks, const std::vector<int>& labs);

}  // namespace cs550::gradebook
