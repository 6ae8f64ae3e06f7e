#pragma once
/// @file command_line.hpp
/// What the programs behind ./cs550 print when a command line asks for help or is wrong.

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <string>

namespace cs550::cli {

/// CLI11's help without what it adds to an option: types, ranges, exclusions. Its line of usage differs from
/// version to version.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(20); }
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
};

/// Makes two things an error: a flag with a value, as in `--list=no`, and an option in the place of a value,
/// as in `--step --hint`.
void check_values(CLI::App& app);

/// Prints a message on standard error in lines of at most 80 columns.
void print_error(const std::string& message);

/// Prints why a verb ended early. The library's words about a file become its path and the system's reason.
void print_failure(const std::exception& failure);

/// Prints the help that was asked for, or what is wrong: with the arguments of the verb if one is missing or not
/// expected.
/// @param verb the verb with the wrong option
/// @return an ExitCode
int answer(const CLI::App& app, const CLI::ParseError& error, const std::string& verb);

/// The main() of a verb with a program of its own: parses the command line, then runs the verb.
/// @return an ExitCode
int run_verb(CLI::App& app, const std::string& verb, int argc, char** argv,
             const std::function<int()>& action);

}  // namespace cs550::cli
