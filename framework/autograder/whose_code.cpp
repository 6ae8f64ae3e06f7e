#include <cs550/whose_code.hpp>

#include <cxxabi.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace cs550::autograder {

std::string whose(const LabFunction& function) {
  const auto address = reinterpret_cast<std::uintptr_t>(function.address);
  for (const CodeSection& section : code_sections()) {
    if (address >= reinterpret_cast<std::uintptr_t>(section.begin) &&
        address < reinterpret_cast<std::uintptr_t>(section.end)) {
      // How they were built matters to the build only: the code is the student's.
      const std::string variant = section.variant;
      return variant == "assembled" || variant == "sanitized" ? "student" : variant;
    }
  }
  return "unknown";
}

std::string readable_name(const LabFunction& function) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(function.symbol, nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : function.symbol;
}

std::string whose_code_text() {
  std::ostringstream text;
  for (const LabFunction& function : lab_functions()) {
    text << whose(function) << " lab" << function.lab << ' ' << readable_name(function) << '\n';
  }
  return text.str();
}

std::string whose_code_json() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const LabFunction& function : lab_functions()) {
    rows.push_back({{"lab", function.lab},
                    {"function", readable_name(function)},
                    {"symbol", function.symbol},
                    {"whose", whose(function)}});
  }
  return rows.dump(2);
}

}  // namespace cs550::autograder
