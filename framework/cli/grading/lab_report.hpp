#pragma once
/// @file lab_report.hpp
/// Printing the verdicts on a lab, and the hint that goes with one.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/grading/graded_tests.hpp"
#include "cli/grading/known_causes.hpp"

namespace cs550::cli {

/// Prints one line for each test. A failed test also prints its report, unless its step comes after
/// the first step that fails: a mistake in one step often fails all later ones. Of that step, the
/// first failing test prints its whole report, with the likely causes of all of them, the most
/// likely ones first. The others print what they expected and got.
class LabReport {
 public:
  /// @param everything print the reports of later steps too, and every cause
  LabReport(bool everything, std::vector<KnownCause> known_causes)
      : everything_(everything), known_causes_(std::move(known_causes)) {}

  void print(const std::vector<Verdict>& verdicts);

  /// Points and tests passed, and what to fix first or, if nothing fails, which lab to write next.
  /// @param elsewhere points that the instructor grades
  /// @param earlier_fault the step or the earlier lab that fails by itself, "L3.1"; may be empty
  void print_total(int elsewhere, const std::string& earlier_fault = "") const;

 private:
  void print_reason(const Verdict& verdict);
  /// The likely causes of all failing tests of the verdict's step, once.
  std::vector<std::string> causes_to_print(const Verdict& verdict);
  std::vector<std::string> first_new(const std::vector<std::string>& causes);
  std::string what_to_fix(const std::string& earlier_fault) const;
  std::string fate_of_other_reports() const;
  void print_lab_to_write() const;
  bool is_after_first_failure(const Verdict& verdict) const;

  bool everything_;
  std::vector<KnownCause> known_causes_;
  Outcomes outcomes_;                                       ///< of the tests printed so far
  std::vector<Verdict> verdicts_;                           ///< printed so far
  std::string first_failing_step_;                          ///< empty while none fails
  std::map<std::string, std::string> reported_;             ///< the test that first had a message
  std::map<std::string, std::vector<std::string>> causes_;  ///< of the failing tests of a step
  std::map<std::string, std::string> endings_;  ///< the first test of a step that ended so
  std::set<std::string> printed_causes_;
  std::set<std::string> explained_steps_;  ///< steps with a whole report
  bool left_out_ = false;                  ///< a report was not printed
  bool shortened_ = false;                 ///< a report was printed in part
};

/// Prints a hint for a test that did not pass: for its step, or for the step that blocks it.
/// @param number 1, 2, 3; 0: the next one
/// @return an ExitCode
int give_hint(const Verdict& failure, int number);

}  // namespace cs550::cli
