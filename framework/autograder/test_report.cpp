#include <cs550/test_report.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace cs550::autograder {
namespace {

struct Reported {
  const testing::TestInfo* test = nullptr;
  std::vector<FailedCheck> checks;
  std::set<int> parts;  ///< their places among GoogleTest's parts of the result
};

/// Of the running test.
Reported& reported() {
  static Reported current;
  const testing::TestInfo* running = testing::UnitTest::GetInstance()->current_test_info();
  if (current.test != running) current = {running, {}, {}};
  return current;
}

bool is_same_case(const TestCase& a, const TestCase& b) {
  return a.property == b.property && a.given == b.given && a.when == b.when;
}

/// Smaller for simpler cases.
std::pair<bool, std::size_t> complexity(const TestCase& at) {
  std::size_t characters = 0;
  for (const std::string& fact : at.given) characters += fact.size();
  for (const std::string& action : at.when) characters += action.size();
  return {at.is_random, characters};
}

const FailedCheck& simplest_of(const std::vector<FailedCheck>& checks) {
  return *std::min_element(checks.begin(), checks.end(),
                           [](const FailedCheck& a, const FailedCheck& b) {
                             return complexity(a.at) < complexity(b.at);
                           });
}

/// One check of each failing case.
std::vector<const FailedCheck*> one_of_each_case(const std::vector<FailedCheck>& checks) {
  std::vector<const FailedCheck*> cases;
  for (const FailedCheck& check : checks) {
    if (std::none_of(cases.begin(), cases.end(),
                     [&](const FailedCheck* other) { return is_same_case(check.at, other->at); })) {
      cases.push_back(&check);
    }
  }
  return cases;
}

/// Each cause once, by the number of failing cases that name it.
std::vector<std::string> common_causes(const std::vector<const FailedCheck*>& cases) {
  std::vector<std::pair<std::string, int>> counts;
  for (const FailedCheck* one : cases) {
    for (const std::string& cause : one->at.causes) {
      const auto known = std::find_if(counts.begin(), counts.end(),
                                      [&](const auto& entry) { return entry.first == cause; });
      if (known == counts.end()) {
        counts.emplace_back(cause, 1);
      } else {
        ++known->second;
      }
    }
  }
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> causes;
  causes.reserve(counts.size());
  for (const auto& [cause, count] : counts) causes.push_back(cause);
  return causes;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// "  label     first item" and the further items below it.
std::string list(std::string label, const std::vector<std::string>& items) {
  label.resize(10, ' ');
  std::string text;
  for (const std::string& item : items) {
    text.append("  ").append(label).append(item).append("\n");
    label.assign(label.size(), ' ');
  }
  return text;
}

std::string facts(const FailedCheck& check) {
  return check.at.property + '\n' + list("given", check.at.given) + list("when", check.at.when) +
         list("then", {check.what}) + list("expected", {check.expected}) + list("got", {check.got});
}

/// What else is wrong in the shown case, and in how many others.
std::string others(const FailedCheck& shown, const std::vector<FailedCheck>& checks,
                   const std::vector<const FailedCheck*>& cases) {
  std::vector<std::string> further;
  for (const FailedCheck& check : checks) {
    if (&check != &shown && is_same_case(check.at, shown.at)) further.push_back(check.what);
  }
  std::string text = further.empty() ? "" : list("also", {joined(further)});
  std::size_t similar = 0;
  std::vector<std::string> properties;
  for (const FailedCheck* one : cases) {
    const std::string& property = one->at.property;
    if (property == shown.at.property) {
      ++similar;
    } else if (std::find(properties.begin(), properties.end(), property) == properties.end()) {
      properties.push_back(property);
    }
  }
  text += list("also", properties);
  --similar;  // the shown case
  if (similar > 0) {
    text += "  +" + std::to_string(similar) + " similar case" + (similar > 1 ? "s" : "") + '\n';
  }
  return text;
}

}  // namespace

std::string summary(const std::vector<FailedCheck>& checks) {
  if (checks.empty()) return {};
  const FailedCheck& shown = simplest_of(checks);
  const std::vector<const FailedCheck*> cases = one_of_each_case(checks);
  return facts(shown) + list("likely", common_causes(cases)) +
         (shown.picture.empty() ? "" : list("picture", {shown.picture})) +
         others(shown, checks, cases);
}

const std::vector<FailedCheck>& failed_checks() { return reported().checks; }

bool is_simplest_so_far(const TestCase& at) {
  const std::vector<FailedCheck>& checks = failed_checks();
  return checks.empty() || complexity(at) < complexity(simplest_of(checks).at);
}

void report_failure(const FailedCheck& check, const char* file, int line) {
  Reported& known = reported();
  if (known.test != nullptr) known.parts.insert(known.test->result()->total_part_count());
  known.checks.push_back(check);
  ADD_FAILURE_AT(file, line) << summary({check});
}

std::vector<std::string> other_failures() {
  const std::string noise = "Failed\n";  // GoogleTest's own first word
  const Reported& known = reported();
  std::vector<std::string> texts;
  if (known.test == nullptr) return texts;
  const testing::TestResult& result = *known.test->result();
  for (int i = 0; i < result.total_part_count(); ++i) {
    if (known.parts.count(i) != 0) continue;
    std::string text = result.GetTestPartResult(i).message();
    if (text.compare(0, noise.size(), noise) == 0) text.erase(0, noise.size());
    while (!text.empty() && text.back() == '\n') text.pop_back();  // added by some versions
    texts.push_back(text);
  }
  return texts;
}

}  // namespace cs550::autograder
