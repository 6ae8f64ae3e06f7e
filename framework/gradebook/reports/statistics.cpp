#include "gradebook/reports/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "gradebook/reports/numbers.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

double percent_of(const LabMark& mark) { return 100 * mark.mark / mark.points; }

/// The marks of those who submitted a lab.
std::vector<const LabMark*> submitted(const std::vector<StudentMark>& marks, int lab) {
  std::vector<const LabMark*> found;
  for (const StudentMark& mark : marks) {
    const LabMark* of_lab = mark.lab(lab);
    if (of_lab != nullptr && of_lab->record != nullptr && of_lab->is_graded) {
      found.push_back(of_lab);
    }
  }
  return found;
}

LabStatistics lab_statistics(const std::vector<StudentMark>& marks, int lab) {
  constexpr int bins = 10;
  LabStatistics result;
  result.lab = lab;
  result.histogram.assign(bins, 0);
  Numbers percents;
  for (const LabMark* mark : submitted(marks, lab)) {
    percents.push_back(percent_of(*mark));
    const int bin = static_cast<int>(percents.back() / (100.0 / bins));
    ++result.histogram[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
    result.not_compiled += mark->lab_record()->fails_to_compile() ? 1 : 0;
  }
  result.submissions = static_cast<int>(percents.size());
  result.missing =
      static_cast<int>(std::count_if(marks.begin(), marks.end(), [lab](const auto& mark) {
        const LabMark* of_lab = mark.lab(lab);
        return mark.student.on_roster && (of_lab == nullptr || of_lab->record == nullptr);
      }));
  result.mean = mean_of(percents);
  result.median = median_of(percents);
  return result;
}

std::vector<TestStatistics> test_statistics(const std::vector<const LabMark*>& marks) {
  std::vector<TestStatistics> tests;
  if (marks.empty()) return tests;
  for (const TestResult& test : marks.front()->lab_record()->tests) {
    TestStatistics result{test.name, test.step, test.hidden, 0, 0, 0, false};
    Numbers passed;
    Numbers others;
    for (const LabMark* mark : marks) {
      const LabRecord& lab = *mark->lab_record();
      const auto same = std::find_if(lab.tests.begin(), lab.tests.end(),
                                     [&test](const TestResult& t) { return t.name == test.name; });
      if (same == lab.tests.end()) continue;
      passed.push_back(same->status == "passed" ? 1 : 0);
      others.push_back(lab.earned() - same->earned);
    }
    result.submissions = static_cast<int>(passed.size());
    result.passed = static_cast<int>(std::count(passed.begin(), passed.end(), 1));
    if (const std::optional<double> r = correlation(passed, others)) {
      result.discrimination = *r;
      result.discriminates = true;
    }
    tests.push_back(std::move(result));
  }
  return tests;
}

/// Over the engines that count and were graded. Every one lists the milestones of all labs that were graded.
std::vector<MilestoneStatistics> milestone_statistics(const std::vector<StudentMark>& marks) {
  std::vector<MilestoneStatistics> milestones;
  for (const StudentMark& mark : marks) {
    if (mark.engine.record == nullptr || !mark.engine.is_graded) continue;
    for (const TestResult& test : mark.engine.record->engine->tests) {
      auto found = std::find_if(milestones.begin(), milestones.end(),
                                [&test](const auto& known) { return known.name == test.name; });
      if (found == milestones.end()) {
        found = milestones.insert(milestones.end(), MilestoneStatistics{test.name, 0, 0});
      }
      ++found->engines;
      found->reached += test.status == "passed" ? 1 : 0;
    }
  }
  return milestones;
}

/// The first line of a message that has text, with every number as #.
std::string likeness(const std::string& message) {
  constexpr std::size_t longest = 120;
  std::string line = plain_text(message);
  line.erase(0, line.find_first_not_of(" \n\t"));
  line = line.substr(0, line.find('\n'));
  std::string text;
  for (const char c : line) {
    const bool is_digit = c >= '0' && c <= '9';
    if (!is_digit) {
      text += c;
    } else if (!text.ends_with('#')) {
      text += '#';
    }
  }
  return shortened(text, longest);
}

std::vector<AlikeFailures> alike_failures(const std::vector<StudentMark>& marks) {
  // Messages of hidden tests tell failures apart too, but are not shown: teachers show this page.
  using Likeness = std::tuple<std::string, std::string, bool>;  // test, message, hidden
  std::map<Likeness, std::vector<const StudentMark*>> groups;
  for (const StudentMark& mark : marks) {
    for (const LabMark& lab : mark.labs) {
      if (lab.lab_record() == nullptr) continue;
      for (const TestResult& test : lab.lab_record()->tests) {
        if (test.status == "passed" || test.message.empty()) continue;
        groups[{test.name, likeness(test.message), test.hidden}].push_back(&mark);
      }
    }
  }
  std::vector<AlikeFailures> failures;
  for (auto& [key, students] : groups) {
    const auto& [test, message, hidden] = key;
    if (students.size() > 1) {
      failures.push_back({test, hidden ? "(a hidden test)" : message, std::move(students)});
    }
  }
  std::stable_sort(failures.begin(), failures.end(),
                   [](const AlikeFailures& a, const AlikeFailures& b) {
                     return a.students.size() > b.students.size();
                   });
  return failures;
}

/// Files that are only starters are equal for everyone and earn nothing.
std::vector<EqualFiles> equal_files(const std::vector<StudentMark>& marks, int lab) {
  std::map<std::string, std::vector<const StudentMark*>> by_hash;
  for (const StudentMark& mark : marks) {
    const LabMark* of_lab = mark.lab(lab);
    if (of_lab != nullptr && of_lab->record != nullptr && of_lab->earned > 0) {
      by_hash[of_lab->lab_record()->hash].push_back(&mark);
    }
  }
  std::vector<EqualFiles> equal;
  for (auto& [hash, students] : by_hash) {
    if (students.size() > 1) equal.push_back({lab, std::move(students)});
  }
  return equal;
}

/// Students far from the class, and labs far from the same student's other labs. Of students with a mark.
std::vector<Outlier> outliers_of(const std::vector<StudentMark>& marks) {
  constexpr double far = 2;       // standard deviations
  constexpr double jump = 50;     // percentage points
  constexpr std::size_t few = 8;  // below, a deviation means nothing
  std::vector<Outlier> outliers;
  const auto has_mark = [](const StudentMark& mark) {
    return !mark.is_missing() && mark.is_graded();
  };
  Numbers totals;
  for (const StudentMark& mark : marks) {
    if (has_mark(mark)) totals.push_back(mark.percent);
  }
  const double mean = mean_of(totals);
  const double deviation = deviation_of(totals);
  for (const StudentMark& mark : marks) {
    if (!has_mark(mark)) continue;
    if (totals.size() >= few && std::abs(mark.percent - mean) > far * deviation) {
      outliers.push_back(
          {&mark, fmt::format("{:.0f}% in all, the class {:.0f}%", mark.percent, mean)});
    }
    for (const LabMark& lab : mark.labs) {
      Numbers others;
      for (const LabMark& other : mark.labs) {
        if (other.lab != lab.lab && other.record != nullptr) others.push_back(percent_of(other));
      }
      if (lab.record == nullptr || others.size() < 2) continue;
      if (std::abs(percent_of(lab) - mean_of(others)) > jump) {
        outliers.push_back({&mark, fmt::format("{:.0f}% in lab {}, {:.0f}% in the others",
                                               percent_of(lab), lab.lab, mean_of(others))});
      }
    }
  }
  return outliers;
}

}  // namespace

ClassStatistics statistics_of(const std::vector<StudentMark>& marks, const std::vector<int>& labs) {
  ClassStatistics result;
  for (const int lab : labs) {
    result.labs.push_back(lab_statistics(marks, lab));
    for (TestStatistics& test : test_statistics(submitted(marks, lab))) {
      result.tests.push_back(std::move(test));
    }
    for (EqualFiles& equal : equal_files(marks, lab)) result.equal.push_back(std::move(equal));
  }
  result.milestones = milestone_statistics(marks);
  result.failures = alike_failures(marks);
  result.outliers = outliers_of(marks);
  return result;
}

}  // namespace cs550::gradebook
