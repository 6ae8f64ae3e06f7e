#include "cli/grading/known_causes.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cli/system/project.hpp"

namespace cs550::cli {
namespace {

std::size_t common(const std::set<std::string>& a, const std::set<std::string>& b) {
  return static_cast<std::size_t>(std::count_if(
      a.begin(), a.end(), [&](const std::string& test) { return b.count(test) != 0; }));
}

/// The failing tests that a cause explains; none if a passing test excludes it.
std::optional<std::size_t> explained(const std::string& cause, const std::vector<KnownCause>& known,
                                     const Outcomes& outcomes) {
  const KnownCause* found = nullptr;  // with the most words, as they may contain those of another
  for (const KnownCause& one : known) {
    const bool names_it = cause.find(one.words) != std::string::npos;
    if (names_it && (found == nullptr || one.words.size() > found->words.size())) found = &one;
  }
  if (found == nullptr) return 1;  // the test that names it
  if (common(found->tests, outcomes.passed) > 0) return std::nullopt;
  return common(found->tests, outcomes.failed);
}

}  // namespace

std::vector<KnownCause> known_causes(const std::string& lab_name) {
  std::ifstream stream(project_root() / "tests" / lab_name / "causes.json");
  std::vector<KnownCause> known;
  if (!stream) return known;
  using Recorded = std::map<std::string, std::set<std::string>>;
  for (const auto& [words, tests] : nlohmann::json::parse(stream).get<Recorded>()) {
    known.push_back({words, tests});
  }
  return known;
}

std::vector<std::string> plausible(const std::vector<std::string>& causes,
                                   const std::vector<KnownCause>& known, const Outcomes& outcomes) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& cause : causes) {
    if (const auto count = explained(cause, known, outcomes)) ranked.emplace_back(*count, cause);
  }
  if (ranked.empty()) return causes;
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  result.reserve(ranked.size());
  for (const auto& [count, cause] : ranked) result.push_back(cause);
  return result;
}

}  // namespace cs550::cli
