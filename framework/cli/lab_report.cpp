#include "lab_report.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "project.hpp"
#include "terminal.hpp"

namespace cs550::cli {
namespace {

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

}  // namespace

std::string title(const std::string& lab_name) {
  const std::size_t topic = lab_name.find('_');
  std::string title = "Lab " + lab_name.substr(3, topic - 3) + ": " + lab_name.substr(topic + 1);
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::string fault_of_lab_number(const std::string& word) {
  std::string fault = "there is no lab " + word + ". The labs:";
  for (const std::string& lab : lab_names()) {
    if (std::to_string(lab_number(lab)) == word) return {};
    fault.append("\n  ").append(title(lab));
  }
  return fault;
}

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

}  // namespace cs550::cli
