// The program behind ./cs550 view.
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "cs550/excerpt.hpp"
#include "files/indented.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"
#include "pages/make_page.hpp"
#include "viewer/options.hpp"
#include "viewer/snapshot.hpp"
#include "viewer/window.hpp"

namespace {

enum ExitCode { Good = 0, Failed = 1, Misused = 2 };

using cs550::viewer::Options;

void print_error(const char* message) {
  std::cerr << cs550::files::indented("cs550: " + cs550::with_short_words(message), 0);
}

/// A page with the settings of the command line.
/// @throws std::invalid_argument for a wrong one
std::unique_ptr<cs550::viewer::Page> page_of(const Options& options) {
  auto page = make_page(options.page());
  page->refresh();
  for (const std::string& assignment : options.settings) {
    cs550::viewer::ControlSetter setter(assignment);
    page->describe(setter);
    setter.expect_found();
  }
  return page;
}

/// @throws std::invalid_argument for a page that cannot be shown, except because of a student's code
/// @throws std::runtime_error for a scene that cannot be read with a student's code
void list_settings(const Options& options) {
  const auto page = page_of(options);
  const std::string& problem = page->content().problem;
  if (!problem.empty() && !options.student) throw std::invalid_argument(problem);
  if (!problem.empty() && page->lab() == 0) {
    const std::string fault = fault_of_scene(options.page());
    if (!fault.empty()) throw std::runtime_error(fault);
    std::cerr << "The scene cannot be made yet, so these are the default settings:\n"
              << cs550::files::indented(cs550::with_short_words(problem), 2);
  }
  cs550::viewer::ControlLister lister;
  page->describe(lister);
  std::cout << lister.text();
}

int run(const Options& options) {
  if (options.list) {
    list_settings(options);
  } else if (options.is_headless()) {
    cs550::files::watch_for_interruption();
    write_pictures(options);
  } else {
    if (!options.settings.empty())
      page_of(options);  // a wrong one is reported without a screen too
    run_in_window(options);
  }
  cs550::files::check_standard_output();
  return Good;
}

}  // namespace

int main(int argc, char** argv) {
  const cs550::viewer::CommandLine line = cs550::viewer::read_command_line(argc, argv);
  if (line.exit_code) return *line.exit_code;
  try {
    return run(line.options);
  } catch (const std::invalid_argument& error) {
    print_error(error.what());
    return Misused;
  } catch (const cs550::viewer::NoScreen& error) {
    print_error(error.what());
    // As it is: a line break inside the quotes of a word would change the word.
    std::cerr << "A picture needs no screen:\n" << error.instead() << '\n';
    return Failed;
  } catch (const std::exception& error) {
    print_error(error.what());
    return Failed;
  }
}
