#pragma once
/// @file usage_fault.hpp
/// Messages about a wrong command line.

#include <string>
#include <vector>

namespace cs550::files {

/// An option or a positional argument of a command line.
struct Argument {
  std::string name;     ///< "--step", or "N" for a positional one
  std::string value;    ///< how --help names its value: "STEP"
  std::string meaning;  ///< what --help states about it
};

/// What the library that parses command lines reports, and what it knows.
struct UsageReport {
  std::string words;
  std::vector<Argument> arguments;             ///< that the command line may have
  std::vector<std::string> unused;             ///< words that it did not expect
  std::vector<std::string> after_dashes = {};  ///< words after "--", which it did not expect either
};

/// What is wrong, in our words where the library has none for a reader. An option that does not exist
/// comes first: its value may have been taken for another argument.
std::string usage_fault(const UsageReport& report);

/// The same, of an App of CLI11, which only the programs include: it is an expensive header.
template <class App, class Error>
std::string usage_fault(const App& app, const Error& error) {
  UsageReport report{error.what(), {}, {}};
  if (!app.get_allow_extras()) report.unused = app.remaining();
  // The library keeps what follows -- with the program, not with the verb.
  if (const App* program = app.get_parent()) {
    for (const std::string& word : program->remaining()) {
      if (word != "--") report.after_dashes.push_back(word);
    }
  }
  for (const auto* option : app.get_options()) {
    report.arguments.push_back(
        {option->get_name(), option->get_option_text(), option->get_description()});
  }
  return usage_fault(report);
}

}  // namespace cs550::files
