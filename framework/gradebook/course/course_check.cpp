#include "gradebook/course/course_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gradebook/course/course_file.hpp"
#include "gradebook/course/course_keys.hpp"

namespace cs550::gradebook {
namespace {

using Form = CourseTable::Form;

/// As it is written in the file, shortened.
std::string as_written(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) {
    if constexpr (toml::is_table<decltype(value)>) {
      text << "a table";
    } else {
      text << value;
    }
  });
  constexpr std::size_t most = 60;
  return text.str().size() <= most ? text.str() : text.str().substr(0, most) + "...";
}

std::string known_labs(const Catalogue& catalogue) {
  std::string labs;
  for (const auto& [number, lab] : catalogue) {
    labs += (labs.empty() ? "" : ", ") + std::to_string(number);
  }
  return labs;
}

/// Checks the file table by table.
class Check {
 public:
  Check(std::string file, const Catalogue& catalogue)
      : file_(std::move(file)), catalogue_(catalogue) {}

  void top(const toml::table& top) const {
    const CourseTable& of_top = course_tables().front();
    for (const auto& [key, node] : top) {
      const CourseTable* table = table_named(key.str());
      if (table == nullptr) {
        entry(of_top, "", key.str(), node);
      } else if (table->form == Form::Single) {
        keys(*table, std::string(table->name), node);
      } else if (table->form == Form::ByLab) {
        labs(*table, node);
      } else {
        list(*table, node);
      }
    }
  }

 private:
  [[noreturn]] void fail(const toml::node& at, const CourseTable& table,
                         const std::string& what) const {
    std::string example;
    std::istringstream lines{std::string(table.example)};
    for (std::string line; std::getline(lines, line);) example += "\n    " + line;
    throw CourseError(fmt::format("{}:{}: {}\n  An example that works:{}", file_,
                                  at.source().begin.line, what, example));
  }

  static const CourseTable* table_named(std::string_view name) {
    for (const CourseTable& table : course_tables()) {
      if (table.form != Form::Top && table.name == name) return &table;
    }
    return nullptr;
  }

  void labs(const CourseTable& table, const toml::node& node) const {
    const toml::table* numbers = node.as_table();
    if (numbers == nullptr) {
      fail(node, table, fmt::format("lab must be tables [lab.N], found {}", as_written(node)));
    }
    for (const auto& [number, settings] : *numbers) {
      check_lab(settings, table, std::string(number.str()), fmt::format("[lab.{}]", number.str()));
      keys(table, fmt::format("lab.{}", number.str()), settings);
    }
  }

  void list(const CourseTable& table, const toml::node& node) const {
    const toml::array* entries = node.as_array();
    if (entries == nullptr) {
      fail(node, table,
           fmt::format("{} must be entries {}, found {}", table.name, table.heading(),
                       as_written(node)));
    }
    for (const toml::node& one : *entries) {
      keys(table, std::string(table.name), one);
      const toml::table& values = *one.as_table();
      check_lab(one, table, std::to_string(values["lab"].value_or(0)),
                fmt::format("{}.lab", table.name));
      if (values.contains("test")) check_test(values, table);
    }
  }

  void keys(const CourseTable& table, const std::string& path, const toml::node& node) const {
    const toml::table* values = node.as_table();
    if (values == nullptr) {
      fail(node, table,
           fmt::format("{} must be a table {}, found {}", path, table.heading(), as_written(node)));
    }
    for (const auto& [key, value] : *values) entry(table, path + '.', key.str(), value);
    for (const CourseKey& key : table.keys) {
      if (key.required && !values->contains(key.name)) {
        fail(node, table,
             fmt::format("{} needs the key {}: {}", table.heading(), key.name, key.expected()));
      }
    }
  }

  void entry(const CourseTable& table, const std::string& path, std::string_view name,
             const toml::node& value) const {
    const CourseKey* key = table.key(name);
    if (key == nullptr) {
      std::string tables;
      if (table.form == Form::Top) {
        for (const CourseTable& other : course_tables()) {
          if (other.form != Form::Top) tables += ", " + other.heading();
        }
      }
      fail(value, table,
           fmt::format("{} has no key {}. Expected: {}{}", table.heading(), name, table.key_names(),
                       tables));
    }
    if (!fits(*key, value)) {
      fail(
          value, table,
          fmt::format("{}{} must be {}, found {}", path, name, key->expected(), as_written(value)));
    }
  }

  static bool fits(const CourseKey& key, const toml::node& value) {
    const auto in_range = [&key](double x) {
      return std::isfinite(x) && x >= key.least && x <= key.most;
    };
    const auto is_choice = [&key](const toml::node& node) {
      const auto word = node.value_exact<std::string_view>();
      return word && std::count(key.choices.begin(), key.choices.end(), *word) > 0;
    };
    switch (key.kind) {
      case ValueKind::Text:
        return value.is_string();
      case ValueKind::Number:
        return value.is_number() && in_range(*value.value<double>());
      case ValueKind::Whole:
        return value.is_integer() && in_range(*value.value<double>());
      case ValueKind::DateTime:
        return value.is_date_time() && value.as_date_time()->get().offset.has_value();
      case ValueKind::Choice:
        return is_choice(value);
      case ValueKind::ListOfChoices:
        return value.is_array() &&
               std::all_of(value.as_array()->begin(), value.as_array()->end(), is_choice);
    }
    return false;
  }

  void check_lab(const toml::node& at, const CourseTable& table, const std::string& number,
                 const std::string& place) const {
    for (const auto& [known, lab] : catalogue_) {
      if (std::to_string(known) == number) return;
    }
    fail(
        at, table,
        fmt::format("{}: there is no lab {}. The labs: {}", place, number, known_labs(catalogue_)));
  }

  void check_test(const toml::table& values, const CourseTable& table) const {
    const std::string test = values["test"].value_or("");
    const CatalogueLab& lab = catalogue_.at(values["lab"].value_or(0));
    if (std::none_of(lab.tests.begin(), lab.tests.end(),
                     [&test](const CatalogueTest& known) { return known.name == test; })) {
      fail(values, table,
           fmt::format("{}.test: lab {} has no test {}. Its manifest lists them", table.name,
                       lab.number, test));
    }
  }

  std::string file_;
  const Catalogue& catalogue_;
};

}  // namespace

void check_course(const toml::table& top, const std::string& file, const Catalogue& catalogue) {
  Check(file, catalogue).top(top);
}

}  // namespace cs550::gradebook
