#pragma once
/// @file course_keys.hpp
/// The tables and keys of the course file, with what each may contain.

#include <string>
#include <string_view>
#include <vector>

namespace cs550::gradebook {

enum class ValueKind { Text, Number, Whole, DateTime, Choice, ListOfChoices };

struct CourseKey {
  std::string_view name;
  ValueKind kind = ValueKind::Text;
  double least = 0;  ///< of numbers
  double most = 0;
  std::vector<std::string_view> choices;
  bool required = false;

  /// What its value must be: "a number from 0 to 100".
  std::string expected() const;
};

/// A table of the file: "" is its top, "lab" has one table per number (`[lab.3]`), and a list has
/// any number of entries (`[[extension]]`).
struct CourseTable {
  enum class Form { Top, Single, ByLab, List };
  std::string_view name;
  Form form = Form::Single;
  std::vector<CourseKey> keys;
  std::string_view example;  ///< a valid course file by itself, with every key of the table

  /// As it is written in the file: "[lab.3]", "[[extension]]", or "the top of the file".
  std::string heading() const;
  /// "clock, percent_per_day, ..."
  std::string key_names() const;
  /// Null if there is none of that name.
  const CourseKey* key(std::string_view name) const;
};

const std::vector<CourseTable>& course_tables();

}  // namespace cs550::gradebook
