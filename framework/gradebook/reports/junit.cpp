#include "gradebook/reports/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gradebook/reports/shown.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

std::string property(const char* name, const std::string& value) {
  return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name, html(value));
}

/// The element that says how a test went; none for one that passed.
std::string verdict(const TestResult& test) {
  if (test.status == "passed") return {};
  if (test.status == "not_submitted" || test.status == "not_graded") {
    return fmt::format("      <skipped message=\"{}\"/>\n", status_text(test));
  }
  const bool is_failure = test.status == "failed" || test.status == "blocked";
  const char* element = is_failure ? "failure" : "error";
  return fmt::format("      <{} type=\"{}\" message=\"{}\">{}</{}>\n", element, html(test.status),
                     status_text(test), html(shown_message(test)), element);
}

std::string test_case(const TestResult& test) {
  const std::size_t dot = test.name.find('.');
  return fmt::format(
      "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n      <properties>\n{}{}{}{}"
      "      </properties>\n{}      <system-out>points {}, earned {}</system-out>\n"
      "    </testcase>\n",
      html(test.name.substr(0, dot)), html(test.name.substr(dot + 1)), test.seconds,
      property("points", std::to_string(test.points)),
      property("earned", std::to_string(test.earned)), property("step", test.step),
      property("hidden", test.hidden ? "true" : "false"), verdict(test), test.points, test.earned);
}

std::string suite(const LabRecord& lab) {
  const auto count = [&lab](const auto& condition) {
    return std::count_if(lab.tests.begin(), lab.tests.end(), condition);
  };
  const auto holds = [](const char* element) {
    return [element](const TestResult& test) {
      return verdict(test).find(element) != std::string::npos;
    };
  };
  std::string text = fmt::format(
      "  <testsuite name=\"Lab{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\">\n    <properties>\n{}{}    </properties>\n",
      lab.lab, lab.tests.size(), count(holds("<failure")), count(holds("<error")),
      count(holds("<skipped")), lab.seconds(), property("points", std::to_string(lab.points())),
      property("earned", std::to_string(lab.earned())));
  for (const TestResult& test : lab.tests) text += test_case(test);
  if (!lab.compile_errors.empty()) {
    text += fmt::format("    <system-err>{}</system-err>\n", html(lab.compile_errors));
  }
  return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const Record& record) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"{}\">\n", html(record.name));
  for (const LabRecord& lab : record.labs) text += suite(lab);
  return text + "</testsuites>\n";
}

}  // namespace cs550::gradebook
