#include "manifest.hpp"

#include <cs550/graded_test.hpp>
#include <nlohmann/json.hpp>

namespace cs550::autograder {

std::string manifest() {
  int visible = 0;
  int hidden = 0;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const std::vector<GradedTestInfo> tests = graded_tests();
  for (const GradedTestInfo& test : tests) {
    (test.hidden() ? hidden : visible) += test.points;
    rows.push_back({{"name", test.name},
                    {"points", test.points},
                    {"step", test.step},
                    {"hidden", test.hidden()},
                    {"long", test.duration == Duration::Long}});
  }
  const nlohmann::ordered_json document = {{"lab", tests.empty() ? 0 : tests.front().lab()},
                                           {"points", {{"visible", visible}, {"hidden", hidden}}},
                                           {"tests", rows}};
  return document.dump(2) + '\n';
}

}  // namespace cs550::autograder
