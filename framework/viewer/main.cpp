// The program behind ./cs550 view.
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "cs550/excerpt.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"
#include "pages/make_page.hpp"
#include "viewer/options.hpp"
#include "viewer/snapshot.hpp"
#include "viewer/window.hpp"

namespace {

enum ExitCode { Good = 0, Failed = 1, Misused = 2 };

void list_settings(const cs550::viewer::Options& options) {
  using namespace cs550::viewer;
  const auto page = make_page(options.page());
  page->refresh();
  ControlLister lister;
  page->describe(lister);
  std::cout << lister.text();
}

/// A wrong setting is reported without a screen too.
/// @throws std::invalid_argument
void check_settings(const cs550::viewer::Options& options) {
  using namespace cs550::viewer;
  if (options.settings.empty()) return;
  const auto page = make_page(options.page());
  page->refresh();
  for (const std::string& assignment : options.settings) {
    ControlSetter setter(assignment);
    page->describe(setter);
    setter.expect_found();
  }
}

int run(const cs550::viewer::Options& options) {
  if (options.list) {
    list_settings(options);
  } else if (options.is_headless()) {
    cs550::files::watch_for_interruption();
    write_pictures(options);
  } else {
    check_settings(options);
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
    std::cerr << "cs550: " << cs550::with_short_words(error.what()) << '\n';
    return Misused;
  } catch (const std::exception& error) {
    std::cerr << "cs550: " << cs550::with_short_words(error.what()) << '\n';
    return Failed;
  }
}
