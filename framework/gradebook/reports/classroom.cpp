#include "gradebook/reports/classroom.hpp"

#include <nlohmann/json.hpp>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {

std::string classroom_json(const Record& record) {
  using Json = nlohmann::ordered_json;
  constexpr int version = 1;
  Json tests = Json::array();
  int most = 0;
  bool all_pass = true;
  for (const LabRecord& lab : record.labs) {
    for (const TestResult& test : lab.tests) {
      if (test.hidden) continue;
      const bool passed = test.status == "passed";
      all_pass = all_pass && passed;
      most += test.points;
      tests.push_back({{"name", test.name},
                       {"status", passed                    ? "pass"
                                  : test.status == "failed" ? "fail"
                                                            : "error"},
                       {"score", test.earned},
                       {"message", plain_text(test.message)},
                       {"test_code", test.step},
                       {"filename", ""},
                       {"line_no", 0},
                       {"execution_time", std::to_string(test.seconds) + "s"}});
    }
  }
  const Json json{{"version", version},
                  {"status", all_pass ? "pass" : "fail"},
                  {"max_score", most},
                  {"tests", tests}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace cs550::gradebook
