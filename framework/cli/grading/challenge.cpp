#include "cli/grading/challenge.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cs550/excerpt.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

namespace {

std::vector<ChallengeCount> to_counts(const Json& rows) {
  std::vector<ChallengeCount> counts;
  for (const Json& row : rows) {
    counts.push_back({row.at("what"), row.at("better") == "fewer", row.at("count")});
  }
  return counts;
}

/// "better by 12 %", "the same", "worse by 3 %".
std::string compared(const ChallengeCount& yours, const ChallengeCount& reference) {
  if (yours.count == reference.count) return "the same";
  const bool is_better = (yours.count < reference.count) == yours.fewer_is_better;
  const auto difference = static_cast<double>(std::labs(yours.count - reference.count));
  const double percent = 100 * difference / static_cast<double>(std::labs(reference.count));
  return fmt::format("{} by {:.2g} %", is_better ? "better" : "worse", percent);
}

}  // namespace

std::vector<ChallengeCount> reference_counts(const std::string& lab_name) {
  const fs::path manifest = project_root() / "tests" / lab_name / "manifest.json";
  return to_counts(Json::parse(read_text(manifest)).value("challenge", Json::array()));
}

std::vector<ChallengeCount> students_counts(int lab) {
  constexpr std::chrono::seconds patience{60};
  const fs::path output = draft_result(fmt::format("lab{}_challenge", lab));
  const Clock::time_point start = Clock::now();
  const Ending ending =
      run({built_program("student", graded_target(lab, Grading::Plain)), "--challenge"},
          {project_root(), output, [&] { return Clock::now() > start + patience; },
           students_limits(false)});
  const std::string printed = read_output(output, ending);
  fs::remove(output);
  if (!ending.good()) {
    throw std::runtime_error("the challenge was not finished: " + ending.in_words() + '\n' +
                             printed);
  }
  const Json counts = Json::parse(printed, nullptr, false);
  if (counts.is_discarded()) {
    throw std::runtime_error("your code prints while it is counted; remove its output:\n" +
                             excerpt(printed));
  }
  return to_counts(counts);
}

void print_counts(const std::vector<ChallengeCount>& yours,
                  const std::vector<ChallengeCount>& reference) {
  for (std::size_t i = 0; i < yours.size() && i < reference.size(); ++i) {
    std::cout << fmt::format("  {}\n      yours {}, the reference's {}: {} ({} is better)\n",
                             yours[i].what, yours[i].count, reference[i].count,
                             compared(yours[i], reference[i]),
                             yours[i].fewer_is_better ? "fewer" : "more");
  }
}

}  // namespace cs550::cli
