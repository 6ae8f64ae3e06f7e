#include "cli/grading/known_causes.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <utility>

#include "cli/system/project.hpp"

namespace cs550::cli {
namespace {

long common(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::count_if(a.begin(), a.end(),
                       [&](const std::string& test) { return b.count(test) != 0; });
}

/// How well a cause explains the endless loops, the failing tests of its step, and those of other steps;
/// nothing if a passing test excludes it.
using Rank = std::tuple<long, long, long>;
std::optional<Rank> rank_of(const std::string& cause, const std::vector<KnownCause>& known,
                            const Outcomes& outcomes) {
  // One sentence may name several mistakes: "in the world and of unit length".
  std::optional<Rank> best;
  bool is_recorded = false;
  for (const KnownCause& one : known) {
    if (cause.find(one.words) == std::string::npos) continue;
    is_recorded = true;
    if (common(one.tests, outcomes.passed) > 0) continue;
    const bool never_ends =
        !one.endless.empty() && common(one.tests, one.endless) == std::ssize(one.tests);
    if (never_ends && outcomes.stopped.empty()) continue;
    const Rank rank{
        common(one.endless, outcomes.stopped), common(one.tests, outcomes.failed),
        common(one.elsewhere, outcomes.failed) - common(one.elsewhere, outcomes.passed)};
    if (!best || rank > *best) best = rank;
  }
  return is_recorded ? best : Rank{0, 1, 0};  // unrecorded: it explains the test that names it
}

}  // namespace

std::vector<KnownCause> known_causes(const std::string& lab_name) {
  std::ifstream stream(project_root() / "tests" / lab_name / "causes.json");
  std::vector<KnownCause> known;
  if (!stream) return known;
  using Tests = std::map<std::string, std::set<std::string>>;  // by where they are
  for (const auto& [words, tests] :
       nlohmann::ordered_json::parse(stream).get<std::map<std::string, Tests>>()) {
    const auto endless = tests.find("endless");
    known.push_back({words, tests.at("step"), tests.at("elsewhere"),
                     endless == tests.end() ? std::set<std::string>() : endless->second});
  }
  return known;
}

std::vector<std::string> plausible(const std::vector<std::string>& causes,
                                   const std::vector<KnownCause>& known, const Outcomes& outcomes) {
  std::vector<std::pair<Rank, std::string>> ranked;
  for (const std::string& cause : causes) {
    if (const auto place = rank_of(cause, known, outcomes)) ranked.emplace_back(*place, cause);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  result.reserve(ranked.size());
  for (const auto& [place, cause] : ranked) result.push_back(cause);
  return result;
}

std::vector<std::string> endless_causes(const std::vector<std::string>& causes,
                                        const std::vector<KnownCause>& known,
                                        const Outcomes& outcomes) {
  std::vector<KnownCause> loops;
  std::copy_if(known.begin(), known.end(), std::back_inserter(loops),
               [&](const KnownCause& one) { return common(one.endless, outcomes.stopped) > 0; });
  std::vector<std::string> candidates;
  std::copy_if(causes.begin(), causes.end(), std::back_inserter(candidates),
               [&](const std::string& cause) {
                 return std::any_of(loops.begin(), loops.end(), [&](const KnownCause& one) {
                   return cause.find(one.words) != std::string::npos;
                 });
               });
  return plausible(candidates, loops, outcomes);
}

}  // namespace cs550::cli
