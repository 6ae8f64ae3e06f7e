#include "verdict.hpp"

#include <tuple>

namespace cs550::cli {

// Within one lab a longer tag has the longer number.
bool is_earlier_step(const std::string& a, const std::string& b) {
  return std::tuple(a.size(), a) < std::tuple(b.size(), b);
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
