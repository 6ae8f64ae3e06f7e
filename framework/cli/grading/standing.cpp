#include "cli/grading/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/grading/lab_files.hpp"
#include "cli/system/build_log.hpp"
#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

namespace {

constexpr const char* program = "milestones_student";

fs::path milestone_file() { return project_root() / "build/results/engine.json"; }

/// Of all labs together: a change in any may change the engine.
std::vector<std::string> fingerprints(const std::vector<LabResult>& labs) {
  std::vector<std::string> list;
  list.reserve(labs.size());
  for (const LabResult& lab : labs) list.push_back(lab.fingerprint);
  return list;
}

std::optional<std::set<int>> remembered_milestones(const std::vector<LabResult>& labs) {
  std::ifstream stream(milestone_file());
  if (!stream) return std::nullopt;
  const Json json = Json::parse(stream, nullptr, false);
  const bool valid = json.is_object() && json.at("lab_files") == Json(fingerprints(labs));
  return valid ? std::optional(json.at("reached").get<std::set<int>>()) : std::nullopt;
}

constexpr std::chrono::seconds longest_milestone{60};

bool reaches(int lab, const std::function<void()>& waiting) {
  const fs::path output = milestone_file().replace_extension(".txt");
  const Clock::time_point start = Clock::now();
  const auto is_stuck = [&] {
    waiting();
    return Clock::now() > start + longest_milestone;
  };
  const Ending ending = run({built_program("student", program), "--lab", std::to_string(lab)},
                            {project_root(), output, is_stuck, students_limits(false), SIGABRT});
  fs::remove(output);
  return ending.good();
}

/// Finds the milestones of these labs that the student's engine reaches. They are remembered until a lab or the
/// framework changes. A build that fails because of the machine is tried again.
void find_milestones(const std::vector<LabResult>& labs, Standing& standing) {
  if (const std::optional<std::set<int>> known = remembered_milestones(labs)) {
    standing.milestones = *known;
    return;
  }
  show_status("Running your engine ...");
  const std::string error = labs.empty() ? "" : build_quietly(program);
  if (!error.empty() && !is_students_error(error)) {
    standing.engine_fault = error;
    return;
  }
  std::set<int>& reached = standing.milestones;
  if (error.empty()) {
    StatusLine status;
    for (const LabResult& lab : labs) {
      const int number = lab_number(lab.lab_name);
      const auto show_lab = [&] {
        status.show([&] {
          return fmt::format("Running your engine, lab {} of {}, at most {} s each", number,
                             labs.size(), longest_milestone.count());
        });
      };
      if (has_milestone(number) && reaches(number, show_lab)) reached.insert(number);
    }
  }
  files::write_file(milestone_file(),
                    Json{{"lab_files", fingerprints(labs)}, {"reached", reached}}.dump(2) + '\n');
}

/// The labs that were begun, up to the first that was not or has no code: the engine can run no further.
std::vector<LabResult> begun(const Standing& standing) {
  std::vector<LabResult> labs;
  for (const LabResult& lab : standing.labs) {
    if (standing.untouched.count(lab.lab_name) != 0) break;
    if (!fault_of_absent_code(lab.lab_name).empty()) break;
    labs.push_back(lab);
  }
  return labs;
}

}  // namespace

Standing look_at_labs() {
  Standing standing;
  for (const std::string& name : lab_names()) {
    const bool untouched = is_untouched(name);
    if (untouched) standing.untouched.insert(name);
    const bool is_next = !standing.next;
    if (untouched && !is_next) {
      standing.labs.push_back(result_of_starter(name));
      continue;
    }
    if (!remembered_result(name)) show_status("Grading " + title(name) + " ...");
    standing.labs.push_back(result_of(name));
    if (is_next && !standing.labs.back().is_finished()) standing.next = standing.labs.size() - 1;
  }
  find_milestones(begun(standing), standing);
  show_status("");
  return standing;
}

bool has_milestone(int lab) {
  const std::string start = fmt::format("lab{}_", lab);
  const auto records = fs::directory_iterator(project_root() / "framework/assets/trajectories");
  return std::any_of(begin(records), end(records), [&start](const fs::directory_entry& record) {
    return record.path().filename().string().rfind(start, 0) == 0;
  });
}

}  // namespace cs550::cli
