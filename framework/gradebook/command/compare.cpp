#include "gradebook/command/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "gradebook/marks/mark.hpp"
#include "gradebook/reports/shown.hpp"

namespace cs550::gradebook {
namespace {

const Record* find(const std::vector<Record>& records, const std::string& name) {
  const auto found = std::find_if(records.begin(), records.end(),
                                  [&name](const Record& record) { return record.name == name; });
  return found == records.end() ? nullptr : &*found;
}

/// "48 of 60", or why there are no points.
std::string points_of(const LabRecord* lab) {
  if (lab == nullptr) return "no record";
  if (!lab->not_graded.empty()) return "not graded";
  if (!lab->submitted) return "not submitted";
  return fmt::format("{} of {}", lab->earned(), lab->points());
}

std::string test_changes(const LabRecord& before, const LabRecord& after) {
  std::map<std::string, const TestResult*> old;
  for (const TestResult& test : before.tests) old[test.name] = &test;
  std::string text;
  for (const TestResult& test : after.tests) {
    const TestResult* was = old[test.name];
    if (was == nullptr) {
      text += fmt::format("    {}: new, {} ({} points)\n", test.name, test.status, test.earned);
    } else if (was->status != test.status || was->earned != test.earned) {
      text += fmt::format("    {}: {} -> {} ({:+} points)\n", test.name, was->status, test.status,
                          test.earned - was->earned);
    }
    old.erase(test.name);
  }
  for (const auto& [name, test] : old) {
    text += fmt::format("    {}: removed ({} points)\n", name, test->earned);
  }
  return text;
}

/// "10 of 21 known mistakes", or why the student's own tests find none.
std::string found_mistakes(const LabRecord& lab) {
  if (!lab.own_tests) return "not run";
  if (!lab.own_tests->not_graded.empty()) return "not graded";
  if (!lab.own_tests->compiled) {
    return lab.own_tests->stopped ? "not compiled" : "does not compile";
  }
  if (lab.own_tests->fails_reference) return "fails on the reference";
  return fmt::format("{} of {} known mistakes", lab.own_tests->caught, lab.own_tests->mistakes);
}

std::string own_tests_changes(const LabRecord& before, const LabRecord& after) {
  const std::string was = found_mistakes(before);
  const std::string is = found_mistakes(after);
  return was == is ? "" : fmt::format("    my_tests.cpp: {} -> {}\n", was, is);
}

std::string lab_changes(const std::string& name, int number, const LabRecord* before,
                        const LabRecord* after) {
  const std::string tests = before != nullptr && after != nullptr
                                ? test_changes(*before, *after) + own_tests_changes(*before, *after)
                                : std::string();
  const bool is_new_content = before != nullptr && after != nullptr && before->hash != after->hash;
  if (points_of(before) == points_of(after) && tests.empty()) return {};
  return fmt::format("{}, lab {}: {} -> {}{}\n{}", name, number, points_of(before),
                     points_of(after), is_new_content ? " (other files)" : "", tests);
}

/// "7 of 9 reached", or why none can be.
std::string milestones_of(const LabRecord& engine) {
  if (!engine.not_graded.empty()) return "not graded";
  if (!engine.submitted) return "not submitted";
  const auto reached = std::count_if(engine.tests.begin(), engine.tests.end(),
                                     [](const auto& test) { return test.status == "passed"; });
  return fmt::format("{} of {} reached", reached, engine.tests.size());
}

/// Of the milestones that both ran.
std::string changed_milestones(const LabRecord& before, const LabRecord& after) {
  std::string text;
  for (const TestResult& milestone : after.tests) {
    for (const TestResult& was : before.tests) {
      if (was.name != milestone.name || was.status == milestone.status) continue;
      text += fmt::format("    {}: {} -> {}\n", milestone.name, milestone_text(was),
                          milestone_text(milestone));
    }
  }
  return text;
}

std::string engine_changes(const Record& before, const Record& after) {
  const std::string was = before.engine ? milestones_of(*before.engine) : "not run";
  const std::string is = after.engine ? milestones_of(*after.engine) : "not run";
  const std::string milestones = before.engine && after.engine
                                     ? changed_milestones(*before.engine, *after.engine)
                                     : std::string();
  if (was == is && milestones.empty()) return {};
  return fmt::format("{}, milestones: {} -> {}\n{}", after.name, was, is, milestones);
}

/// The labs of the first list that are not in the second: one line for the class, not one for every student.
std::string labs_only_in(const std::vector<int>& labs, const std::vector<int>& others,
                         const std::string& folder) {
  std::string text;
  for (const int lab : labs) {
    if (std::count(others.begin(), others.end(), lab) > 0) continue;
    text += fmt::format("lab {}: only in the {} folder, not compared\n", lab, folder);
  }
  return text;
}

}  // namespace

std::string comparison(const std::vector<Record>& before, const std::vector<Record>& after) {
  const std::vector<int> old_labs = labs_of(before);
  const std::vector<int> new_labs = labs_of(after);
  std::string text =
      labs_only_in(old_labs, new_labs, "first") + labs_only_in(new_labs, old_labs, "second");
  int compared = 0;
  int changed = 0;
  for (const Record& record : after) {
    const Record* was = find(before, record.name);
    if (was == nullptr) {
      text += record.name + ": new\n";
      continue;
    }
    ++compared;
    std::string changes;
    for (const int lab : new_labs) {
      if (std::count(old_labs.begin(), old_labs.end(), lab) == 0) continue;
      changes += lab_changes(record.name, lab, was->lab(lab), record.lab(lab));
    }
    changes += engine_changes(*was, record);
    changed += changes.empty() ? 0 : 1;
    text += changes;
  }
  for (const Record& record : before) {
    if (find(after, record.name) == nullptr) text += record.name + ": removed\n";
  }
  return text + fmt::format("{} of {} submissions changed.\n", changed, compared);
}

}  // namespace cs550::gradebook
