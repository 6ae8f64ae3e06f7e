#include "standing.hpp"

#include <unistd.h>

#include <iostream>

#include "engine_score.hpp"
#include "lab_files.hpp"
#include "lab_report.hpp"
#include "project.hpp"
#include "terminal.hpp"

namespace cs550::cli {

namespace {

/// On a terminal, in a line that the next words replace; no words leave it empty.
void say_what_runs(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::cerr << '\r' << padded(what, 48) << '\r' << std::flush;
}

/// The labs that were begun, up to the first that was not: the engine can run no further.
std::vector<LabResult> begun(const Standing& standing) {
  std::vector<LabResult> labs;
  for (const LabResult& lab : standing.labs) {
    if (standing.untouched.count(lab.lab_name) != 0) break;
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
    if (!remembered_result(name)) say_what_runs("Grading " + title(name) + " ...");
    standing.labs.push_back(result_of(name));
    if (is_next && !standing.labs.back().is_finished()) standing.next = standing.labs.size() - 1;
  }
  say_what_runs("Running your engine ...");
  standing.milestones = milestones_reached(begun(standing));
  say_what_runs("");
  return standing;
}

}  // namespace cs550::cli
