#include "helpers/story.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "helpers/picture.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

/// What was found. If it is not a number, where such a value comes from follows.
std::string found(const std::string& value, bool is_nan) {
  return is_nan ? value + ": not a number. It comes from 0/0 or the root of a negative number"
                : value;
}

}  // namespace

Story::Story(std::string property) {
  case_.property = std::move(property);
  autograder::note_case(case_);
}

Story& Story::given(const std::string& fact) {
  case_.given.push_back(fact);
  autograder::note_case(case_);
  return *this;
}

Story& Story::when(const std::string& action) {
  case_.when.push_back(action);
  autograder::note_case(case_);
  return *this;
}

Story& Story::seed(std::uint32_t seed) {
  case_.is_random = true;
  return given("seed", seed, seed_salt() == 0 ? "" : "and the course's salt");
}

Story& Story::likely(const std::string& cause) {
  case_.causes.push_back(cause);
  autograder::note_case(case_);
  return *this;
}

Story& Story::picture(std::function<std::string()> draw) {
  draw_ = std::move(draw);
  return *this;
}

bool Story::expect(const std::string& what, bool holds, SourceLine at) {
  return holds ? passed() : failed(what, "no", "yes", at);
}

bool Story::expect(const std::string& what, bool holds, const std::string& got,
                   const std::string& expected, SourceLine at) {
  return holds ? passed() : failed(what, got, expected, at);
}

bool Story::expect_near(const std::string& what, double got, double expected, double tolerance,
                        const std::string& unit, SourceLine at) {
  const double allowed = std::abs(tolerance);
  if (std::abs(got - expected) <= allowed) return passed();
  return failed(what, found(show(got, unit), std::isnan(got)),
                show(expected, unit) + " ± " + show(allowed, unit), at);
}

bool Story::expect_near(const std::string& what, const Vec3& got, const Vec3& expected,
                        double tolerance, const std::string& unit, SourceLine at) {
  const double allowed = std::abs(tolerance);
  if (static_cast<double>((got - expected).norm()) <= allowed) return passed();
  return failed(what, found(show(got, unit), got.hasNaN()),
                show(expected, unit) + " ± " + show(allowed, unit), at);
}

bool Story::expect_at_most(const std::string& what, double got, double bound,
                           const std::string& unit, SourceLine at) {
  return got <= bound ? passed()
                      : failed(what, found(show(got, unit), std::isnan(got)),
                               "at most " + show(bound, unit), at);
}

bool Story::expect_at_least(const std::string& what, double got, double bound,
                            const std::string& unit, SourceLine at) {
  return got >= bound ? passed()
                      : failed(what, found(show(got, unit), std::isnan(got)),
                               "at least " + show(bound, unit), at);
}

bool Story::expect_index(const std::string& what, Index index, Index count, SourceLine at) {
  if (0 <= index && index < count) return passed();
  return failed(what, show(index), "0 to " + show(count - 1), at);
}

std::string Story::show(double value, const std::string& unit) {
  return show(fmt::format("{:.7g}", value), unit);
}

std::string Story::show(const Vec3& value, const std::string& unit) {
  return show(fmt::format("({:.7g}, {:.7g}, {:.7g})", value.x(), value.y(), value.z()), unit);
}

std::string Story::show(const Quat& value, const std::string& unit) {
  return "w = " + show(value.w()) + ", xyz = " + show(Vec3(value.vec()), unit);
}

std::string Story::show(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

bool Story::passed() {
  autograder::note_passed_check();
  return true;
}

bool Story::failed(const std::string& what, const std::string& got, const std::string& expected,
                   SourceLine at) const {
  const bool is_shown = draw_ && autograder::is_simplest_so_far(case_);
  autograder::report_failure({case_, what, expected, got, is_shown ? write_picture(draw_) : ""},
                             at.file, at.line);
  return false;
}

}  // namespace cs550::test
