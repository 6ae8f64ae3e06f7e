#include "cli/command_line.hpp"

#include <iostream>

#include "cli/system/exit_code.hpp"

namespace cs550::cli {

std::string Help::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : ' ' + option->get_option_text();
}

void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) option->disable_flag_override();
  }
}

int answer(const CLI::App& app, const CLI::ParseError& error, const std::string& verb) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::cerr << "cs550: " << error.what() << "\n./cs550 " << verb
            << " --help explains the options.\n";
  return Misused;
}

}  // namespace cs550::cli
