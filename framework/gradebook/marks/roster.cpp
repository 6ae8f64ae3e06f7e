#include "gradebook/marks/roster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "gradebook/intake/discovery.hpp"
#include "gradebook/marks/csv_table.hpp"
#include "gradebook/marks/time_text.hpp"

namespace cs550::gradebook {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Without spaces at its ends.
std::string trimmed(const std::string& text) {
  constexpr const char* spaces = " \t";
  const std::size_t first = text.find_first_not_of(spaces);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

/// Whether a byte is that of a letter or a digit. Letters of other alphabets have bytes from 0x80 in UTF-8.
bool is_of_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalnum(byte) != 0;
}

/// "doe_ada_s0101-lab3" has the words doe, ada, s0101, lab3.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : lower(text) + ' ') {
    if (is_of_word(c)) {
      word += c;
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

/// Where an id is in a name.
struct Span {
  std::size_t begin, end;
};

bool is_within_longer(const Span& span, const std::vector<Span>& others) {
  return std::any_of(others.begin(), others.end(), [&span](const Span& other) {
    return other.begin <= span.begin && span.end <= other.end &&
           span.end - span.begin < other.end - other.begin;
  });
}

/// Where a student's id is in a name, with no letter or digit beside it.
std::vector<Span> spans_of_id(const Student& student, const std::string& name) {
  const std::string id = lower(student.id);
  std::vector<Span> spans;
  for (auto begin = name.find(id); begin != name.npos; begin = name.find(id, begin + 1)) {
    const std::size_t end = begin + id.size();
    const bool begins = begin == 0 || !is_of_word(name[begin - 1]);
    const bool ends = end == name.size() || !is_of_word(name[end]);
    if (begins && ends) spans.push_back({begin, end});
  }
  return spans;
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

using Places = std::vector<std::size_t>;

/// The places in the roster of the students for whom a condition holds.
template <typename Condition>
Places places(const std::vector<Student>& roster, const Condition& condition) {
  Places found;
  for (std::size_t i = 0; i < roster.size(); ++i) {
    if (condition(roster[i])) found.push_back(i);
  }
  return found;
}

/// Those who are called by a name. Of a name with further words, those whose id or name is in it: a
/// platform adds the name of the file, which a student chooses, to that of the student. An id that is a
/// part of another one in the name does not count: "lab3-ada-l" is not ada's if there is an ada-l.
Places fitting(const std::vector<Student>& roster, const std::string& name) {
  Places found = places(roster, [&](const Student& s) { return is_called(s, name); });
  if (!found.empty()) return found;
  const std::string text = lower(name);
  std::vector<Span> ids;
  for (const Student& student : roster) {
    for (const Span& span : spans_of_id(student, text)) ids.push_back(span);
  }
  const auto has_id = [&](const Student& student) {
    const std::vector<Span> spans = spans_of_id(student, text);
    return std::any_of(spans.begin(), spans.end(),
                       [&ids](const Span& span) { return !is_within_longer(span, ids); });
  };
  const std::set<std::string> words = words_of(name);
  return places(roster, [&](const Student& s) { return has_id(s) || has_name(words, s); });
}

/// Those whom a platform has named. Else those whom the first name fits that fits anybody: of the folders around a
/// record from the outermost on, which may be that of a section, and then of its file, which a student chooses.
Places owners(const std::vector<Student>& roster, const Record& record) {
  if (record.is_identified) {
    return places(roster, [&](const Student& s) { return is_called(s, record.student); });
  }
  std::vector<std::string> names{record.student};
  names.insert(names.end(), record.folders.begin(), record.folders.end());
  names.push_back(without_ending(record.source));
  for (const std::string& name : names) {
    if (Places found = fitting(roster, name); !found.empty()) return found;
  }
  return {};
}

Student* student_of(std::vector<Student>& roster, const Record& record) {
  Places found = owners(roster, record);
  if (found.empty() && !record.is_identified) {
    found = places(roster, [&](const Student& s) { return is_called(s, record.claimed_student); });
  }
  return found.size() == 1 ? &roster[found.front()] : nullptr;
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
    for (std::size_t i = 0; i < rows[0].size(); ++i) column[lower(trimmed(rows[0][i]))] = i;
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
      const bool is_there = found != column.end() && found->second < rows[i].size();
      return is_there ? trimmed(rows[i][found->second]) : "";
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
  if (roster.empty()) throw std::runtime_error(file + " has a header line and no students");
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
  std::vector<std::string> ids;
  for (const std::size_t i : owners(roster, record)) ids.push_back(roster[i].id);
  return ids.size() > 1 ? ids : std::vector<std::string>();
}

}  // namespace cs550::gradebook
