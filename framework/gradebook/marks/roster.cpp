#include "gradebook/marks/roster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "gradebook/marks/csv_table.hpp"
#include "gradebook/marks/time_text.hpp"

namespace cs550::gradebook {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "doe_ada_s0101-lab3" has the words doe, ada, s0101, lab3.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : lower(text) + ' ') {
    const bool is_letter = static_cast<unsigned char>(c) >= 0x80;  // of other alphabets, in UTF-8
    if (is_letter || std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += c;
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

bool is_called(const Student& student, const std::string& name) {
  const std::string wanted = lower(name);
  if (wanted.empty()) return false;
  return wanted == lower(student.id) || wanted == lower(student.email) ||
         wanted == lower(student.name);
}

/// "Ada Lovelace_123_assignsubmission_file_", as Moodle calls a folder, has all words of her name.
bool has_name(const std::set<std::string>& words, const Student& student) {
  const std::set<std::string> name = words_of(student.name);
  return !name.empty() && std::includes(words.begin(), words.end(), name.begin(), name.end());
}

/// The only student for whom a condition holds; null if there is none, or several.
template <typename Condition>
Student* only_one(std::vector<Student>& roster, const Condition& condition) {
  Student* found = nullptr;
  for (Student& student : roster) {
    if (!student.on_roster || !condition(student)) continue;
    if (found != nullptr) return nullptr;
    found = &student;
  }
  return found;
}

Student* student_of(std::vector<Student>& roster, const Record& record) {
  Student* student =
      only_one(roster, [&](const Student& s) { return is_called(s, record.student); });
  if (student == nullptr) {
    const std::set<std::string> words = words_of(record.student);
    student = only_one(roster, [&](const Student& s) { return words.contains(lower(s.id)); });
    if (student == nullptr) {
      student = only_one(roster, [&](const Student& s) { return has_name(words, s); });
    }
  }
  if (student == nullptr) {
    student =
        only_one(roster, [&](const Student& s) { return is_called(s, record.claimed_student); });
  }
  return student;
}

std::optional<Time> submission_time(const std::string& text, const std::string& place) {
  if (text.empty()) return std::nullopt;
  if (const std::optional<Time> time = parse_time(text)) return time;
  throw std::runtime_error(place + ": submitted must be a time such as 2026-10-12T23:59:00+02:00" +
                           ", found " + text);
}

}  // namespace

bool is_about(const std::string& entry, const Student& student) {
  const std::string name = lower(entry);
  return name == lower(student.id) || (!name.empty() && name == lower(student.email));
}

std::vector<Student> parse_roster(const std::string& text, const std::string& file) {
  const std::vector<std::vector<std::string>> rows = parse_csv(text, file);
  std::map<std::string, std::size_t> column;
  if (!rows.empty()) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) column[lower(rows[0][i])] = i;
  }
  if (!column.contains("id")) {
    throw std::runtime_error(file + ":1: the roster has no column id. For example:\n" +
                             "    id,name,email\n    s0101,Ada Lovelace,ada@example.org");
  }
  std::vector<Student> roster;
  std::set<std::string> ids;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto field = [&](const char* name) {
      const auto found = column.find(name);
      return found != column.end() && found->second < rows[i].size() ? rows[i][found->second] : "";
    };
    const std::string place = fmt::format("{}, row {}", file, i + 1);
    Student student{field("id"),
                    field("name"),
                    field("email"),
                    field("section"),
                    submission_time(field("submitted"), place),
                    true,
                    {}};
    if (student.id.empty()) throw std::runtime_error(place + " has no id");
    if (!ids.insert(lower(student.id)).second) {
      throw std::runtime_error(place + ": the id " + student.id + " occurs twice");
    }
    roster.push_back(std::move(student));
  }
  return roster;
}

std::vector<Student> assign(std::vector<Student> roster, const std::vector<Record>& records) {
  const bool has_roster = !roster.empty();
  std::map<std::string, Student> others;
  for (const Record& record : records) {
    Student* student = student_of(roster, record);
    if (student == nullptr) {
      student = &others[record.student];
      student->id = record.student;
      student->on_roster = !has_roster;
    }
    student->records.push_back(&record);
  }
  for (auto& [id, student] : others) roster.push_back(std::move(student));
  return roster;
}

std::vector<std::string> rivals(const std::vector<Student>& roster, const Record& record) {
  const std::set<std::string> words = words_of(record.student);
  const auto ids_of = [&roster](const auto& condition) {
    std::vector<std::string> ids;
    for (const Student& student : roster) {
      if (condition(student)) ids.push_back(student.id);
    }
    return ids.size() > 1 ? ids : std::vector<std::string>();
  };
  std::vector<std::string> ids =
      ids_of([&](const Student& s) { return is_called(s, record.student); });
  if (ids.empty()) ids = ids_of([&](const Student& s) { return words.contains(lower(s.id)); });
  if (ids.empty()) ids = ids_of([&](const Student& s) { return has_name(words, s); });
  return ids;
}

}  // namespace cs550::gradebook
