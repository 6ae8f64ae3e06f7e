#include "gradebook/course/course_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "gradebook/course/course_check.hpp"
#include "gradebook/course/course_dates.hpp"

namespace cs550::gradebook {
namespace {

using Node = toml::node_view<const toml::node>;

/// The position of a checked word in the list of an enumeration's words.
template <typename Enum, std::size_t N>
Enum choice(const Node& node, const std::array<std::string_view, N>& words, Enum otherwise) {
  const auto word = node.value<std::string_view>();
  if (!word) return otherwise;
  return static_cast<Enum>(std::find(words.begin(), words.end(), *word) - words.begin());
}

Visibility visibility(const Node& node, Visibility otherwise) {
  using namespace std::string_view_literals;
  return choice(node, std::array{"visible"sv, "hidden"sv, "after_due_date"sv, "after_published"sv},
                otherwise);
}

/// Of a written time from UTC; the check has found that there is one.
std::chrono::minutes offset(const Node& node) {
  return std::chrono::minutes(node.value<toml::date_time>()->offset->minutes);
}

std::optional<Time> time(const Node& node) {
  const auto written = node.value<toml::date_time>();
  if (!written) return std::nullopt;
  using namespace std::chrono;
  const year_month_day date{year{written->date.year}, month{written->date.month},
                            day{written->date.day}};
  return sys_days(date) + hours(written->time.hour) + minutes(written->time.minute) +
         seconds(written->time.second) - offset(node);
}

Limits limits(const Node& node) {
  return {node["wall"].value<int>(), node["cpu"].value<int>(), node["memory"].value<int>(),
          node["lab"].value<int>()};
}

LabSettings lab_settings(const Node& node) {
  return {node["weight"].value_or(1.0),    node["points"].value_or(60.0),
          node["own_tests"].value_or(0.0), time(node["due"]),
          time(node["solution_released"]), limits(node)};
}

LatePolicy late_policy(const Node& node) {
  using namespace std::string_view_literals;
  return {choice(node["clock"], std::array{"file"sv, "manifest"sv, "roster"sv}, Clock::File),
          node["percent_per_day"].value_or(0.0), node["grace_minutes"].value_or(0.0),
          node["most_percent"].value_or(100.0)};
}

/// Calls `read` with each entry of a list; not at all where the list is absent.
template <typename Read>
void for_each_entry(const Node& list, const Read& read) {
  if (const toml::array* entries = list.as_array()) {
    for (const toml::node& entry : *entries) read(Node(entry));
  }
}

Course to_course(const toml::table& table) {
  using namespace std::string_view_literals;
  const Node top(table);
  Course course;
  course.title = top["title"].value_or(course.title);
  course.secret = top["secret"].value_or("");
  course.retention_days = top["retention_days"].value<int>();
  course.attempt = choice(top["attempt"], std::array{"best"sv, "last"sv}, Attempt::Best);
  for_each_entry(top["leaderboard"],
                 [&](const Node& word) { course.leaderboard.push_back(word.value_or("")); });
  course.limits = limits(top["limits"]);
  course.visible_tests = visibility(top["visibility"]["visible_tests"], course.visible_tests);
  course.hidden_tests = visibility(top["visibility"]["hidden_tests"], course.hidden_tests);
  if (top["late"]) course.late = late_policy(top["late"]);
  course.milestones_weight = top["milestones"]["weight"].value_or(0.0);
  if (const toml::table* labs = top["lab"].as_table()) {
    for (const auto& [number, settings] : *labs) {
      course.labs[std::stoi(std::string(number.str()))] = lab_settings(Node(settings));
    }
  }
  for_each_entry(top["adjustment"], [&](const Node& entry) {
    course.adjustments.push_back({entry["student"].value_or(""), entry["lab"].value_or(0),
                                  entry["points"].value_or(0.0), entry["reason"].value_or("")});
  });
  for_each_entry(top["extension"], [&](const Node& entry) {
    course.extensions.push_back({entry["student"].value_or(""), entry["lab"].value_or(0),
                                 *time(entry["due"]), offset(entry["due"]),
                                 entry["reason"].value_or("")});
  });
  for_each_entry(top["regrade"], [&](const Node& entry) {
    course.regrades.push_back(
        {entry["student"].value_or(""), entry["lab"].value_or(0), entry["test"].value_or(""),
         choice(entry["status"], std::array{"open"sv, "granted"sv, "declined"sv},
                RegradeRequest::Status::Open),
         entry["note"].value_or("")});
  });
  return course;
}

}  // namespace

Course parse_course(const std::string& text, const std::string& file, const Catalogue& catalogue) {
  try {
    const toml::table table = toml::parse(text, file);
    check_course(table, file, catalogue);
    Course course = to_course(table);
    check_dates(course, file);
    return course;
  } catch (const toml::parse_error& error) {
    throw CourseError(
        fmt::format("{}:{}: this is not TOML: {}\n  An example that works:\n"
                    "    [lab.3]\n    points = 100",
                    file, error.source().begin.line, error.description()));
  }
}

}  // namespace cs550::gradebook
