#include "gradebook/reports/class_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "gradebook/reports/grades_csv.hpp"
#include "gradebook/reports/page.hpp"
#include "gradebook/reports/statistics.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

const std::string& name_of(const Student& student) {
  return student.name.empty() ? student.id : student.name;
}

/// The student's name, linked to the feedback on the first submission.
std::string link(const StudentMark& mark) {
  std::string name = html(name_of(mark.student));
  if (mark.is_missing()) return name;
  return fmt::format("<a href=\"feedback/{}.html\">{}</a>",
                     html(mark.student.records.front()->name), name);
}

std::string links(const std::vector<const StudentMark*>& students) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, students.size()); ++i) {
    text += (text.empty() ? "" : ", ") + link(*students[i]);
  }
  if (students.size() > most) text += fmt::format(" and {} more", students.size() - most);
  return text;
}

std::string lab_cards(const std::vector<LabStatistics>& labs) {
  std::string cards;
  for (const LabStatistics& lab : labs) {
    cards += fmt::format(
        "<div class=\"card\"><h3>Lab {}</h3>\n<p>mean {:.0f}%, median {:.0f}%</p>\n"
        "<p class=\"faint\">{} submitted, {} missing, {} do not compile</p>\n{}</div>\n",
        lab.lab, lab.mean, lab.median, lab.submissions, lab.missing, lab.not_compiled,
        bar_chart(lab.histogram, {"0", "10", "20", "30", "40", "50", "60", "70", "80", "90+"},
                  fmt::format("Lab {}: number of students per 10% of the points", lab.lab)));
  }
  return "<div class=\"cards\">\n" + cards + "</div>\n";
}

std::string test_rows(std::vector<TestStatistics> tests) {
  const auto rate = [](const TestStatistics& test) {
    return test.submissions == 0 ? 1.0 : static_cast<double>(test.passed) / test.submissions;
  };
  std::stable_sort(tests.begin(), tests.end(),
                   [&rate](const auto& a, const auto& b) { return rate(a) < rate(b); });
  std::string rows;
  for (const TestStatistics& test : tests) {
    rows += fmt::format(
        "<tr><td>{}</td><td>{}{}</td><td class=\"number\">{} of {}</td><td class=\"number\">"
        "{:.0f}%</td><td class=\"number {}\">{}</td></tr>\n",
        html(test.step), html(test.name), test.hidden ? " <small>hidden</small>" : "", test.passed,
        test.submissions, 100 * rate(test),
        test.discriminates && test.discrimination < 0 ? "bad" : "",
        test.discriminates ? fmt::format("{:.2f}", test.discrimination) : "–");
  }
  return rows;
}

std::string test_tables(const std::vector<TestStatistics>& tests) {
  constexpr std::size_t hardest = 10;
  const std::vector<std::string> headings{"Step", "Test", "Passed", "", "Discrimination"};
  const std::string rows = test_rows(tests);
  std::size_t end = 0;
  for (std::size_t i = 0; i < hardest && end != std::string::npos; ++i) {
    end = rows.find("</tr>\n", end);
    if (end != std::string::npos) end += 6;
  }
  return "<p class=\"faint\">Discrimination is the correlation of passing the test with the points "
         "of the lab's other tests. Near 0 or below, the test does not tell good work from "
         "bad.</p>\n" +
         table(headings, rows.substr(0, end)) +
         (end < rows.size() ? details("All tests", table(headings, rows)) : "");
}

std::string milestone_table(const std::vector<MilestoneStatistics>& milestones) {
  std::string rows;
  for (const MilestoneStatistics& milestone : milestones) {
    rows += fmt::format(
        "<tr><td>{}</td><td class=\"number\">{} of {}</td><td class=\"number\">{:.0f}%</td></tr>\n",
        html(milestone.name), milestone.reached, milestone.engines,
        100.0 * milestone.reached / milestone.engines);
  }
  return table({"Milestone", "Reached", ""}, rows);
}

std::string failure_table(const std::vector<AlikeFailures>& failures) {
  constexpr std::size_t most = 30;
  std::string rows;
  for (std::size_t i = 0; i < std::min(most, failures.size()); ++i) {
    rows += fmt::format(
        "<tr><td class=\"number\">{}</td><td>{}<br><small>{}</small></td><td>{}</td></tr>\n",
        failures[i].students.size(), html(failures[i].test), html(failures[i].message),
        links(failures[i].students));
  }
  return table({"Students", "Test and message", "Who"}, rows);
}

/// What is wrong with a student's submissions.
std::string status(const StudentMark& mark) {
  const std::string trouble = trouble_of(mark.student);
  const std::string text = trouble.empty() ? status_of(mark) : trouble;
  return text == "graded" ? "" : "<span class=\"bad\">" + html(text) + "</span>";
}

/// A mark, linked to the feedback on the submission that counts.
std::string mark_cell(const LabMark& lab) {
  std::string mark =
      lab.is_graded && (lab.record != nullptr || lab.mark > 0) ? points_text(lab.mark) : "–";
  if (lab.record != nullptr) {
    mark = fmt::format("<a href=\"feedback/{}.html\">{}</a>", html(lab.record->name), mark);
  }
  return fmt::format("<td class=\"number\">{}{}</td>", mark,
                     lab.late_days > 0 ? " <small>late</small>" : "");
}

/// The milestones that a student's engine reaches, linked to the feedback on that submission.
std::string engine_cell(const EngineMark& engine) {
  if (engine.record == nullptr) return "<td class=\"number\">–</td>";
  const std::string reached =
      engine.is_graded ? fmt::format("{} of {}", engine.reached, engine.of) : "–";
  return fmt::format("<td class=\"number\"><a href=\"feedback/{}.html\">{}</a></td>",
                     html(engine.record->name), reached);
}

std::string student_table(const std::vector<StudentMark>& marks, const std::vector<int>& labs) {
  const bool has_engines = have_engines(marks);
  std::vector<std::string> headings{"Student", "Total"};
  for (const int lab : labs) headings.push_back(fmt::format("Lab {}", lab));
  if (has_engines) headings.emplace_back("Milestones");
  headings.emplace_back("");
  std::string rows;
  for (const StudentMark& mark : marks) {
    rows += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td>", link(mark),
                        mark.is_graded() ? fmt::format("{:.1f}%", mark.percent) : "–");
    for (const LabMark& lab : mark.labs) rows += mark_cell(lab);
    if (has_engines) rows += engine_cell(mark.engine);
    rows += "<td>" + status(mark) + "</td></tr>\n";
  }
  return table(headings, rows);
}

std::string oddities(const ClassStatistics& statistics) {
  std::string text;
  if (!statistics.equal.empty()) {
    std::string rows;
    for (const EqualFiles& equal : statistics.equal) {
      rows += fmt::format("<li>Lab {}: {}</li>\n", equal.lab, links(equal.students));
    }
    text += "<h2>Equal files</h2>\n<ul>\n" + rows + "</ul>\n";
  }
  if (!statistics.outliers.empty()) {
    std::string rows;
    for (const Outlier& outlier : statistics.outliers) {
      rows += fmt::format("<li>{}: {}</li>\n", link(*outlier.student), html(outlier.why));
    }
    text += "<h2>Outliers</h2>\n<ul>\n" + rows + "</ul>\n";
  }
  return text;
}

/// How the submissions were kept from the machine: "bubblewrap", or several kinds.
std::string isolations(const std::vector<StudentMark>& marks) {
  std::set<std::string> kinds;
  for (const StudentMark& mark : marks) {
    for (const Record* record : mark.student.records) {
      for (const LabRecord& lab : record->labs) kinds.insert(lab.isolation);
    }
  }
  kinds.erase("");
  return fmt::format("{}", fmt::join(kinds, ", "));
}

/// "18 students, 2 without a submission. 1 name is not on the roster."
std::string class_size(const std::vector<StudentMark>& marks) {
  const auto strangers = std::count_if(
      marks.begin(), marks.end(), [](const StudentMark& mark) { return !mark.student.on_roster; });
  const auto missing = std::count_if(marks.begin(), marks.end(),
                                     [](const StudentMark& mark) { return mark.is_missing(); });
  const auto students = static_cast<std::ptrdiff_t>(marks.size()) - strangers;
  std::string text = fmt::format("{} student{}, {} without a submission.", students,
                                 students == 1 ? "" : "s", missing);
  if (strangers == 1) text += " 1 name is not on the roster.";
  if (strangers > 1) text += fmt::format(" {} names are not on the roster.", strangers);
  return text;
}

}  // namespace

std::string class_page(const std::vector<StudentMark>& marks, const std::vector<int>& labs,
                       const Course& course) {
  const ClassStatistics statistics = statistics_of(marks, labs);
  std::string body = "<h1>" + html(course.title) + "</h1>\n<p>" + class_size(marks) + "</p>\n";
  if (const std::string kinds = isolations(marks); !kinds.empty()) {
    body += "<p class=\"faint\">Isolation of submissions: " + html(kinds) + ".</p>\n";
  }
  body += "<h2>Distribution</h2>\n" + lab_cards(statistics.labs);
  body += "<h2>Hardest tests</h2>\n" + test_tables(statistics.tests);
  if (!statistics.milestones.empty()) {
    body += "<h2>Milestones</h2>\n" + milestone_table(statistics.milestones);
  }
  if (!statistics.failures.empty()) {
    body += "<h2>Alike failures</h2>\n" + failure_table(statistics.failures);
  }
  body += oddities(statistics);
  body += "<h2>Students</h2>\n" + student_table(marks, labs);
  return page(course.title, body);
}

}  // namespace cs550::gradebook
