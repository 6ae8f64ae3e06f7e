#include "cli/command_line.hpp"

#include <exception>
#include <iostream>
#include <memory>

#include "cli/system/exit_code.hpp"
#include "cs550/excerpt.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

std::string Help::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : ' ' + option->get_option_text();
}

void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) option->disable_flag_override();
  }
}

namespace {

/// What is wrong, in our words where the library's say nothing to a reader.
std::string complaint(const CLI::ParseError& error) {
  const std::string words = error.what();
  const std::size_t flag_end = words.find(" was given a disallowed flag override");
  if (flag_end == std::string::npos) return with_short_words(words);
  return "--" + words.substr(0, flag_end) + " takes no value";
}

}  // namespace

int answer(const CLI::App& app, const CLI::ParseError& error, const std::string& verb) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::cerr << "cs550: " << complaint(error) << "\n./cs550 " << verb
            << " --help explains the options.\n";
  return Misused;
}

int run_verb(CLI::App& app, const std::string& verb, int argc, char** argv,
             const std::function<int()>& action) {
  app.formatter(std::make_shared<Help>());
  refuse_values_of_flags(app);
  try {
    app.parse(argc, argv);
    const int exit_code = action();
    files::check_standard_output();
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return answer(app, error, verb);
  } catch (const std::exception& error) {
    std::cerr << "cs550: " << with_short_words(error.what()) << '\n';
    return Failed;
  }
}

}  // namespace cs550::cli
