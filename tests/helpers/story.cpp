#include "helpers/story.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "helpers/picture.hpp"

namespace cs550::test {

namespace {

/// "  label    first item" and the further items below it.
void list(std::ostream& out, const char* label, const std::vector<std::string>& items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    out << "  " << (i == 0 ? label : "          ") << items[i] << '\n';
  }
}

}  // namespace

Story::Story(std::string property) : property_(std::move(property)) {}

Story& Story::given(const std::string& fact) {
  givens_.push_back(fact);
  return *this;
}

Story& Story::when(const std::string& action) {
  actions_.push_back(action);
  return *this;
}

Story& Story::seed(std::uint32_t seed) { return given("seed", seed); }

Story& Story::likely(const std::string& cause) {
  causes_.push_back(cause);
  return *this;
}

Story& Story::picture(std::function<std::string()> draw) {
  draw_ = std::move(draw);
  return *this;
}

bool Story::expect(const std::string& what, bool holds, SourceLine at) {
  if (!holds) report(what, "no", "yes", at);
  return holds;
}

bool Story::expect_near(const std::string& what, double got, double expected, double tolerance,
                        const std::string& unit, SourceLine at) {
  const bool holds = std::abs(got - expected) <= tolerance;
  if (!holds)
    report(what, show(got, unit), show(expected, unit) + " ± " + show(tolerance, unit), at);
  return holds;
}

bool Story::expect_near(const std::string& what, const Vec3& got, const Vec3& expected,
                        double tolerance, const std::string& unit, SourceLine at) {
  const bool holds = static_cast<double>((got - expected).norm()) <= tolerance;
  if (!holds)
    report(what, show(got, unit), show(expected, unit) + " ± " + show(tolerance, unit), at);
  return holds;
}

bool Story::expect_at_most(const std::string& what, double got, double bound,
                           const std::string& unit, SourceLine at) {
  const bool holds = got <= bound;
  if (!holds) report(what, show(got, unit), "at most " + show(bound, unit), at);
  return holds;
}

bool Story::expect_at_least(const std::string& what, double got, double bound,
                            const std::string& unit, SourceLine at) {
  const bool holds = got >= bound;
  if (!holds) report(what, show(got, unit), "at least " + show(bound, unit), at);
  return holds;
}

std::string Story::show(const Vec3& value, const std::string& unit) {
  std::ostringstream text;
  text.precision(7);
  text << '(' << value.x() << ", " << value.y() << ", " << value.z() << ')';
  return unit.empty() ? text.str() : text.str() + " " + unit;
}

std::string Story::show(bool value, const std::string&) { return value ? "yes" : "no"; }

std::string Story::show(const char* value, const std::string&) { return value; }

void Story::report(const std::string& what, const std::string& got, const std::string& expected,
                   SourceLine at) const {
  std::ostringstream text;
  text << property_ << '\n';
  list(text, "given     ", givens_);
  list(text, "when      ", actions_);
  text << "  then      " << what << '\n';
  text << "  expected  " << expected << '\n';
  text << "  got       " << got << '\n';
  list(text, "likely    ", causes_);
  const std::string file = draw_ ? write_picture(draw_) : "";
  if (!file.empty()) list(text, "picture   ", {file});
  ADD_FAILURE_AT(at.file, at.line) << text.str();
}

}  // namespace cs550::test
