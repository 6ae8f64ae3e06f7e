#include "manifest.hpp"

#include <cs550/challenge.hpp>
#include <cs550/graded_test.hpp>
#include <cs550/not_implemented.hpp>
#include <nlohmann/json.hpp>

namespace cs550::autograder {
namespace {

nlohmann::ordered_json counts() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Challenge& challenge : challenges()) {
    rows.push_back({{"what", challenge.what},
                    {"better", challenge.better == Better::Fewer ? "fewer" : "more"},
                    {"count", challenge.count()}});
  }
  return rows;
}

}  // namespace

std::string challenge_counts() { return counts().dump(2) + '\n'; }

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
  nlohmann::ordered_json document = {{"lab", tests.empty() ? 0 : tests.front().lab()},
                                     {"points", {{"visible", visible}, {"hidden", hidden}}},
                                     {"tests", rows}};
  try {
    document["challenge"] = counts();
  } catch (const NotImplemented&) {
    // A starter has nothing to count.
  }
  return document.dump(2) + '\n';
}

}  // namespace cs550::autograder
