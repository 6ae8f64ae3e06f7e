#include "cli/grading/earlier_labs.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/grading/lab_files.hpp"
#include "cli/grading/lab_result.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"

namespace cs550::cli {
namespace {

/// The earlier labs that the failing tests call, as tests/mutants/record_earlier_labs.py has recorded
/// them.
std::set<int> called_by_failing(const std::string& lab_name, const std::vector<Verdict>& verdicts) {
  std::ifstream stream(project_root() / "tests" / lab_name / "earlier_labs.json");
  if (!stream) return {};
  const auto recorded = nlohmann::json::parse(stream).get<std::map<std::string, std::set<int>>>();
  std::set<int> labs;
  for (const Verdict& verdict : verdicts) {
    const auto found = recorded.find(verdict.test.name);
    if (verdict.kind != Verdict::Kind::Failed || found == recorded.end()) continue;
    labs.insert(found->second.begin(), found->second.end());
  }
  return labs;
}

}  // namespace

void warn_of_earlier_labs(const std::string& lab_name, const std::vector<Verdict>& verdicts) {
  for (const int number : called_by_failing(lab_name, verdicts)) {
    const std::string earlier = cli::lab_name(number);
    if (has_reference(earlier) || is_untouched(earlier)) continue;
    show_status("Checking " + title(earlier) + " ...");
    const LabResult result = result_of(earlier);
    show_status("");
    const std::optional<Verdict> failure = result.next_failure();
    if (!failure) continue;
    const std::string fault =
        result.compile_error.empty() ? "fails " + failure->step_to_mend() : "does not compile";
    std::cout << coloured(fmt::format("Lab {} itself {}: fix that first.", number, fault),
                          Colour::Yellow)
              << fmt::format(" (./cs550 lab {})\n\n", number);
  }
}

}  // namespace cs550::cli
