#include "cli/grading/graded_tests.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "cli/handout/handout.hpp"
#include "cli/system/project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

Json manifest(const std::string& lab_name) {
  const fs::path file = project_root() / "tests" / lab_name / "manifest.json";
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(lab_name + " has no graded tests: " + file.string() + " is missing");
  return Json::parse(stream);
}

bool has_hidden_tests(const std::string& lab_name) {
  return fs::exists(project_root() / "tests" / lab_name / "hidden");
}

/// The place of a step in its lab's writing order; after all others if it has none.
std::size_t place_in_order(const std::string& step) {
  static std::map<std::string, std::vector<std::string>> orders;  // by the start of a tag, "L2"
  const std::string lab = step.substr(0, step.find('.'));
  const auto [known, is_new] = orders.try_emplace(lab);
  if (is_new) known->second = writing_order(lab_of_step(step));
  const std::vector<std::string>& order = known->second;
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), step) - order.begin());
}

}  // namespace

std::vector<GradedTest> graded_tests(const std::string& lab_name) {
  const bool with_hidden = has_hidden_tests(lab_name);
  const Json listed = manifest(lab_name).at("tests");
  std::vector<GradedTest> tests;
  for (const Json& test : listed) {
    if (test.at("hidden") && !with_hidden) continue;
    tests.push_back({test.at("name"), test.at("step"), test.at("points"), test.at("long")});
  }
  std::stable_sort(tests.begin(), tests.end(), [](const GradedTest& a, const GradedTest& b) {
    return is_earlier_step(a.step, b.step);
  });
  return tests;
}

int points_graded_elsewhere(const std::string& lab_name) {
  return has_hidden_tests(lab_name) ? 0 : manifest(lab_name).at("points").at("hidden").get<int>();
}

bool is_earlier_step(const std::string& a, const std::string& b) {
  // Within one lab a longer tag has the longer number.
  return std::tuple(place_in_order(a), a.size(), a) < std::tuple(place_in_order(b), b.size(), b);
}

std::string to_string(Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::Passed:
      return "passed";
    case Verdict::Kind::Blocked:
      return "blocked";
    case Verdict::Kind::Failed:
      return "failed";
  }
  return {};
}

Verdict::Kind verdict_kind(const std::string& word) {
  if (word == "passed") return Verdict::Kind::Passed;
  if (word == "blocked") return Verdict::Kind::Blocked;
  return Verdict::Kind::Failed;
}

}  // namespace cs550::cli
