// ./cs550 progress: the labs, the points, and what to do next.
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "key_by_key.hpp"
#include "lab_files.hpp"
#include "project.hpp"
#include "standing.hpp"
#include "standing_view.hpp"
#include "terminal.hpp"
#include "verb.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

struct ProgressOptions {
  bool watch = false;
  bool list = false;
  bool hint = false;
  bool next = false;
};

/// When each lab file was last saved. Asking the file system is enough for so few files, and works
/// where file events do not, as on Windows drives under WSL.
std::map<fs::path, fs::file_time_type> times_of_saving() {
  std::map<fs::path, fs::file_time_type> times;
  for (const std::string& name : lab_names()) {
    for (const fs::path& file : lab_files(name)) {
      std::error_code absent;  // for an instant, while an editor replaces it
      times[file] = fs::last_write_time(file, absent);
    }
  }
  return times;
}

void clear_screen() { std::cout << "\033[H\033[2J\033[3J"; }

void answer(char key, const Standing& standing) {
  clear_screen();
  switch (key) {
    case 'h':
      print_hint(standing);
      break;
    case 'n':
      print_next(standing);
      break;
    case 'l':
      print_tests(standing);
      break;
    default:
      print_overview(standing);
  }
  std::cout << coloured("\nh hint   n next step   l list of tests   r run   q quit", Colour::Faint)
            << std::flush;
}

int watch() {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    std::cerr << "cs550: --watch needs a terminal\n";
    return Misused;
  }
  const KeyByKey keys;
  auto saved = times_of_saving();
  Standing standing = look_at_labs();
  answer('r', standing);
  while (true) {
    char key = KeyByKey::wait();
    if (key == 'q') break;
    auto now = times_of_saving();
    if (now != saved) key = 'r';
    if (key == 'r') {
      saved = std::move(now);
      standing = look_at_labs();
    }
    if (key != 0) answer(key, standing);
  }
  std::cout << '\n';
  return Good;
}

int run_progress(const ProgressOptions& options) {
  if (options.watch) return watch();
  const Standing standing = look_at_labs();
  if (options.hint) return print_hint(standing);
  if (options.list) {
    print_tests(standing);
  } else if (options.next) {
    print_next(standing);
  } else {
    print_overview(standing);
  }
  return Good;
}

}  // namespace

Action declare_progress(CLI::App& app) {
  const auto options = std::make_shared<ProgressOptions>();
  std::vector<CLI::Option*> views{
      app.add_flag("--watch", options->watch,
                   "again after every save; keys: h hint, n next, l list, r run, q quit"),
      app.add_flag("--next", options->next, "the next step, and all that its failing test says"),
      app.add_flag("--list", options->list, "every test of the lab that is next"),
      app.add_flag("--hint", options->hint, "one hint more for the next step")};
  for (CLI::Option* view : views) {
    for (CLI::Option* other : views) {
      if (view != other) view->excludes(other);
    }
  }
  return [options] { return run_progress(*options); };
}

}  // namespace cs550::cli
