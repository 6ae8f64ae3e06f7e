#include "manifest.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

Json manifest(const std::string& lab_name) {
  const fs::path file = project_root() / "tests" / lab_name / "manifest.json";
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(lab_name + " has no graded tests yet (no " + file.string() + ")");
  return Json::parse(stream);
}

bool has_hidden_tests(const std::string& lab_name) {
  return fs::exists(project_root() / "tests" / lab_name / "hidden");
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

}  // namespace cs550::cli
