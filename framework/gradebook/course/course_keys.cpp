#include "gradebook/course/course_keys.hpp"

#include <fmt/format.h>

namespace cs550::gradebook {
namespace {

using Form = CourseTable::Form;
using Words = std::vector<std::string_view>;

constexpr bool required = true;
constexpr double hour = 3600;  // seconds
constexpr double lots = 1e6;

CourseKey text(std::string_view name, bool is_required = false) {
  return {name, ValueKind::Text, 0, 0, {}, is_required};
}
CourseKey number(std::string_view name, double least, double most, bool is_required = false) {
  return {name, ValueKind::Number, least, most, {}, is_required};
}
CourseKey whole(std::string_view name, double least, double most, bool is_required = false) {
  return {name, ValueKind::Whole, least, most, {}, is_required};
}
CourseKey time(std::string_view name, bool is_required = false) {
  return {name, ValueKind::DateTime, 0, 0, {}, is_required};
}
CourseKey choice(std::string_view name, Words choices, bool is_required = false) {
  return {name, ValueKind::Choice, 0, 0, std::move(choices), is_required};
}

const Words leaderboards{"points", "seconds", "challenge"};
const Words visibilities{"visible", "hidden", "after_due_date", "after_published"};

std::vector<CourseTable> make_tables() {
  return {{"",
           Form::Top,
           {text("title"),
            text("secret"),
            whole("retention_days", 1, 36500),
            choice("attempt", {"best", "last"}),
            {"leaderboard", ValueKind::ListOfChoices, 0, 0, leaderboards, false}},
           R"(title = "Rigid bodies, autumn 2026"
secret = "a sentence that no student can guess"
retention_days = 400
attempt = "best"
leaderboard = ["points", "seconds"])"},
          {"limits",
           Form::Single,
           {whole("wall", 1, hour), whole("cpu", 1, hour), whole("memory", 256, 1 << 20),
            whole("lab", 1, hour)},
           R"([limits]
wall = 300
cpu = 300
memory = 2048
lab = 600)"},
          {"visibility",
           Form::Single,
           {choice("visible_tests", visibilities), choice("hidden_tests", visibilities)},
           R"([visibility]
visible_tests = "visible"
hidden_tests = "after_published")"},
          {"late",
           Form::Single,
           {choice("clock", {"file", "manifest", "roster"}, required),
            number("percent_per_day", 0, 100, required), number("grace_minutes", 0, lots),
            number("most_percent", 0, 100)},
           R"([late]
clock = "file"
percent_per_day = 10
grace_minutes = 15
most_percent = 50)"},
          {"lab",
           Form::ByLab,
           {number("weight", 0, lots), number("points", 1, lots), number("own_tests", 0, lots),
            time("due"), time("solution_released"), whole("wall", 1, hour), whole("cpu", 1, hour),
            whole("memory", 256, 1 << 20), whole("lab", 1, hour)},
           R"([lab.3]
weight = 1.5
points = 100
own_tests = 5
due = 2026-10-12T23:59:00+02:00
solution_released = 2026-10-20T08:00:00+02:00
wall = 60
cpu = 60
memory = 1024
lab = 120)"},
          {"milestones", Form::Single, {number("weight", 0, lots, required)}, R"([milestones]
weight = 0.5)"},
          {"adjustment",
           Form::List,
           {text("student", required), whole("lab", 1, lots, required),
            number("points", -lots, lots, required), text("reason", required)},
           R"([[adjustment]]
student = "ada"
lab = 3
points = 2.5
reason = "explained the plateau case at the whiteboard")"},
          {"extension",
           Form::List,
           {text("student", required), whole("lab", 1, lots, required), time("due", required),
            text("reason")},
           R"([[extension]]
student = "ada"
lab = 3
due = 2026-10-19T23:59:00+02:00
reason = "illness")"},
          {"regrade",
           Form::List,
           {text("student", required), whole("lab", 1, lots, required), text("test", required),
            choice("status", {"open", "granted", "declined"}, required), text("note")},
           R"([[regrade]]
student = "ada"
lab = 3
test = "Lab3.FirstOfEqualVerticesWins"
status = "granted"
note = "the contract allowed either vertex at that time")"}};
}

std::string joined(const Words& words, std::string_view quote) {
  std::string text;
  for (const std::string_view word : words) {
    text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", quote, word, quote);
  }
  return text;
}

}  // namespace

std::string CourseKey::expected() const {
  switch (kind) {
    case ValueKind::Text:
      return "text in quotes";
    case ValueKind::Number:
      return fmt::format("a number from {:.0f} to {:.0f}", least, most);
    case ValueKind::Whole:
      return fmt::format("a whole number from {:.0f} to {:.0f}", least, most);
    case ValueKind::DateTime:
      return "a date and time with its offset, such as 2026-10-12T23:59:00+02:00";
    case ValueKind::Choice:
      return "one of " + joined(choices, "\"");
    case ValueKind::ListOfChoices:
      return "a list with any of " + joined(choices, "\"");
  }
  return {};
}

std::string CourseTable::heading() const {
  switch (form) {
    case Form::Top:
      return "the top of the file";
    case Form::Single:
      return fmt::format("[{}]", name);
    case Form::ByLab:
      return fmt::format("[{}.N]", name);
    case Form::List:
      return fmt::format("[[{}]]", name);
  }
  return {};
}

std::string CourseTable::key_names() const {
  Words names;
  for (const CourseKey& key : keys) names.push_back(key.name);
  return joined(names, "");
}

const CourseKey* CourseTable::key(std::string_view wanted) const {
  for (const CourseKey& key : keys) {
    if (key.name == wanted) return &key;
  }
  return nullptr;
}

const std::vector<CourseTable>& course_tables() {
  static const std::vector<CourseTable> tables = make_tables();
  return tables;
}

}  // namespace cs550::gradebook
