// ./cs550 lab N: the graded tests of one lab, on the student's code.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "graded_run.hpp"
#include "process.hpp"
#include "project.hpp"
#include "terminal.hpp"
#include "verb.hpp"

namespace cs550::cli {
namespace {

using std::chrono::seconds;

struct LabOptions {
  int lab = 0;
  std::string step;
  bool asan = false;
  bool debug = false;
};

/// A lab's name as people say it: "Lab 3: hill climbing".
std::string title(const std::string& lab_name) {
  const std::size_t topic = lab_name.find('_');
  std::string title = "Lab " + lab_name.substr(3, topic - 3) + ": " + lab_name.substr(topic + 1);
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::string verdict_word(const Verdict& verdict) {
  switch (verdict.kind) {
    case Verdict::Kind::Passed:
      return coloured("passed ", Colour::Green);
    case Verdict::Kind::Blocked:
      return coloured("blocked", Colour::Yellow);
    case Verdict::Kind::Failed:
      return coloured("FAILED ", Colour::Red);
  }
  return {};
}

/// One line for each test, and what it said. The same words are not said twice in a row: an
/// unwritten function stops many tests.
void print(const std::vector<Verdict>& verdicts) {
  std::string said;
  for (const Verdict& verdict : verdicts) {
    std::ostringstream points;
    points << verdict.earned() << '/' << verdict.test.points;
    std::cout << "  " << verdict_word(verdict) << ' ' << std::setw(5) << points.str() << "  "
              << padded(verdict.test.step, 6) << verdict.test.name << '\n';
    if (verdict.message != said) std::cout << indented(verdict.message, 6);
    said = verdict.message;
  }
  std::cout << std::flush;
}

std::vector<GradedTest> only(const std::vector<GradedTest>& tests, bool is_long) {
  std::vector<GradedTest> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [is_long](const GradedTest& test) { return test.is_long == is_long; });
  return chosen;
}

std::vector<GradedTest> of_step(const std::vector<GradedTest>& tests, const std::string& step) {
  std::vector<GradedTest> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [&](const GradedTest& test) { return step.empty() || test.step == step; });
  return chosen;
}

std::string steps_of(const std::vector<GradedTest>& tests) {
  std::set<std::string> steps;
  for (const GradedTest& test : tests) steps.insert(test.step);
  std::string list;
  for (const std::string& step : steps) list += (list.empty() ? "" : ", ") + step;
  return list;
}

void print_total(const std::vector<Verdict>& verdicts, int elsewhere) {
  int earned = 0;
  int points = 0;
  std::size_t passed = 0;
  for (const Verdict& verdict : verdicts) {
    earned += verdict.earned();
    points += verdict.test.points;
    passed += verdict.kind == Verdict::Kind::Passed ? 1 : 0;
  }
  std::ostringstream total;
  total << earned << " of " << points << " points, " << passed << " of " << verdicts.size()
        << " tests passed";
  std::cout << '\n' << coloured(total.str(), Colour::Bold) << '\n';
  if (elsewhere > 0) std::cout << elsewhere << " more points are graded by your instructor.\n";
}

/// The first test that is not passed, in the debugger.
int debug_first_failure(int lab, const std::vector<Verdict>& verdicts) {
  const auto verdict = std::find_if(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
    return verdict.kind != Verdict::Kind::Passed;
  });
  if (verdict == verdicts.end()) {
    std::cout << "Every test passes: there is nothing to debug.\n";
    return Good;
  }
  const std::string name = "lab" + std::to_string(lab) + "_student";
  if (!build("debug", name)) return Failed;
  std::cout << "gdb stops where " << verdict->test.name << " fails; `up` leads to your code.\n"
            << std::flush;
  become({"gdb", "-q", "-ex", "catch throw", "-ex", "run", "--args", built_program("debug", name),
          "--gtest_break_on_failure", "--gtest_filter=*." + verdict->test.name});
}

int run_lab(const LabOptions& options) {
  const std::string name = lab_name(options.lab);
  if (name.empty()) {
    const std::vector<std::string> labs = lab_names();
    std::cerr << "cs550: there is no lab " << options.lab << ". The labs:\n";
    for (const std::string& lab : labs) std::cerr << "  " << title(lab) << '\n';
    return Misused;
  }
  const std::vector<GradedTest> tests = of_step(graded_tests(name), options.step);
  if (tests.empty()) {
    std::cerr << "cs550: lab " << options.lab << " has no step " << options.step
              << ". Its steps: " << steps_of(graded_tests(name)) << '\n';
    return Misused;
  }

  const std::string preset = options.asan ? "asan" : "student";
  const std::string target = "lab" + std::to_string(options.lab) + "_student";
  if (!build(preset, target)) return Failed;

  std::cout << coloured(title(name), Colour::Bold) << "\n\n";
  const int slowdown = options.asan ? 5 : 1;
  std::vector<Verdict> verdicts;
  const auto run_and_print = [&](const std::vector<GradedTest>& chosen, seconds patience) {
    const std::vector<Verdict> outcome =
        run_graded_tests(built_program(preset, target), options.lab, chosen, slowdown * patience);
    print(outcome);
    verdicts.insert(verdicts.end(), outcome.begin(), outcome.end());
  };
  run_and_print(only(tests, false), seconds{5});
  const std::vector<GradedTest> long_tests = only(tests, true);
  if (!long_tests.empty()) {
    std::cout << coloured("  The long tests:", Colour::Faint) << std::endl;
    run_and_print(long_tests, seconds{60});
  }
  print_total(verdicts, options.step.empty() ? points_graded_elsewhere(name) : 0);

  if (options.debug) return debug_first_failure(options.lab, verdicts);
  const bool all_passed = std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
    return verdict.kind == Verdict::Kind::Passed;
  });
  return all_passed ? Good : Failed;
}

}  // namespace

Action declare_lab(CLI::App& app) {
  const auto options = std::make_shared<LabOptions>();
  app.add_option("N", options->lab, "number of the lab")->required();
  app.add_option("--step", options->step, "only the tests of this step, as in L3.2");
  auto* asan =
      app.add_flag("--asan", options->asan, "look for memory errors and undefined behaviour");
  app.add_flag("--debug", options->debug, "then open gdb where the first failing test fails")
      ->excludes(asan);
  return [options] { return run_lab(*options); };
}

}  // namespace cs550::cli
