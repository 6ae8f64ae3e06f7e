#include "cli/grading/earlier_labs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "cli/grading/lab_files.hpp"
#include "cli/grading/lab_result.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {
namespace {

using LabsOfTests = std::map<std::string, std::set<int>>;

/// The earlier labs that each test calls, as tests/mutants/record_earlier_labs.py has recorded them.
LabsOfTests recorded_calls(const std::string& lab_name) {
  std::ifstream stream(project_root() / "tests" / lab_name / "earlier_labs.json");
  return stream ? nlohmann::ordered_json::parse(stream).get<LabsOfTests>() : LabsOfTests();
}

/// The earlier labs that may be why tests did not pass: those that a failing test calls, and those that
/// block a test.
std::set<int> suspects(const std::string& lab_name, const std::vector<Verdict>& verdicts) {
  const LabsOfTests calls = recorded_calls(lab_name);
  std::set<int> labs;
  for (const Verdict& verdict : verdicts) {
    if (verdict.is_blocked_by_other_lab()) {
      labs.insert(lab_number(lab_of_step(verdict.blocked_by)));
    } else if (const auto found = calls.find(verdict.test.name);
               verdict.kind == Verdict::Kind::Failed && found != calls.end()) {
      labs.insert(found->second.begin(), found->second.end());
    }
  }
  return labs;
}

}  // namespace

std::vector<EarlierFault> warn_of_earlier_labs(const std::string& lab_name,
                                               const std::vector<Verdict>& verdicts) {
  std::vector<EarlierFault> faults;
  for (const int number : suspects(lab_name, verdicts)) {
    const std::string earlier = cli::lab_name(number);
    if (has_reference(earlier) || is_untouched(earlier)) continue;
    show_status("Checking " + title(earlier) + " ...");
    const LabResult result = result_of(earlier);
    show_status("");
    const std::optional<Verdict> failure = result.next_failure();
    if (!failure) continue;
    const bool compiles = result.compile_error.empty();
    const std::string step = compiles ? failure->step_to_mend() : "";
    const EarlierFault fault{number, step, compiles ? "fails " + step : result.defect()};
    std::cout << coloured(fmt::format("Lab {} itself {}: fix that first.", number, fault.defect),
                          Colour::Yellow)
              << fmt::format(" (./cs550 lab {})\n\n", number);
    faults.push_back(fault);
  }
  return faults;
}

void explain_blocked_tests(std::vector<Verdict>& verdicts,
                           const std::vector<EarlierFault>& faults) {
  for (Verdict& verdict : verdicts) {
    if (!verdict.is_blocked_by_other_lab()) continue;
    const int lab = lab_number_of_step(verdict.blocked_by);
    const auto unbuilt = std::find_if(
        faults.begin(), faults.end(),
        [lab](const EarlierFault& fault) { return fault.lab == lab && fault.step.empty(); });
    if (unbuilt == faults.end()) continue;
    verdict.message = fmt::format("blocked by lab {}, which {}", lab, unbuilt->defect);
  }
}

}  // namespace cs550::cli
