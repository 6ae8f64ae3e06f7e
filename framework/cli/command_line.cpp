#include "cli/command_line.hpp"

#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "cli/system/exit_code.hpp"
#include "cli/system/terminal.hpp"
#include "cs550/excerpt.hpp"
#include "files/output_file.hpp"
#include "files/usage_fault.hpp"

namespace cs550::cli {

void print_error(const std::string& message) {
  std::cerr << indented("cs550: " + with_short_words(message), 0);
}

void print_failure(const std::exception& failure) {
  const auto* of_files = dynamic_cast<const std::filesystem::filesystem_error*>(&failure);
  print_error(of_files == nullptr ? failure.what()
                                  : of_files->path1().string() + ": " + of_files->code().message());
}

std::string Help::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : ' ' + option->get_option_text();
}

std::string Help::make_usage(const CLI::App* app, std::string name) const {
  std::string usage = "Usage: " + std::move(name) + " [OPTIONS]";
  for (const CLI::Option* option : app->get_options()) {
    if (option->get_positional()) usage += ' ' + make_option_usage(option);
  }
  return usage + (app->get_require_subcommand_min() > 0 ? " SUBCOMMAND\n" : "\n");
}

void check_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) {
      option->disable_flag_override();
    } else if (option->nonpositional()) {
      option->transform([option](std::string value) {
        const bool is_option = value.rfind("--", 0) == 0;
        if (is_option) throw CLI::ArgumentMismatch::TypedAtLeast(option->get_name(), 1, "value");
        return value;
      });
    }
  }
}

int answer(const CLI::App& app, const CLI::ParseError& error, const std::string& verb) {
  if (error.get_exit_code() == 0) return app.exit(error);
  const auto verbs = app.get_subcommands();
  const CLI::App& part = verbs.empty() ? app : *verbs.front();
  print_error(files::usage_fault(part, error));
  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (code == CLI::ExitCodes::RequiredError || code == CLI::ExitCodes::ExtrasError) {
    std::cerr << Help().make_usage(&part, "./cs550 " + verb);
  }
  std::cerr << "./cs550 " << verb << " --help explains the options.\n";
  return Misused;
}

int run_verb(CLI::App& app, const std::string& verb, int argc, char** argv,
             const std::function<int()>& action) {
  app.formatter(std::make_shared<Help>());
  check_values(app);
  try {
    app.parse(argc, argv);
    const int exit_code = action();
    files::check_standard_output();
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return answer(app, error, verb);
  } catch (const std::exception& error) {
    print_failure(error);
    return Failed;
  }
}

}  // namespace cs550::cli
