// ./cs550 progress: the labs, the points, and what to do next.
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "engine_score.hpp"
#include "handout.hpp"
#include "hints.hpp"
#include "lab_files.hpp"
#include "lab_report.hpp"
#include "lab_result.hpp"
#include "project.hpp"
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

/// All labs, and the first of them that is not finished.
struct Progress {
  std::vector<LabResult> labs;
  std::set<std::string> untouched;  ///< labs that are still the starter
  std::optional<std::size_t> next;
  std::set<int> milestones;  ///< labs whose milestones the assembled engine reaches
};

bool is_finished(const LabResult& lab) { return lab.earned() == lab.points(); }

void say_what_runs(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::cerr << '\r' << padded(what + " ...", 48) << '\r' << std::flush;
}

/// The labs that were begun, up to the first that was not: the engine can run no further.
std::vector<LabResult> begun(const Progress& progress) {
  std::vector<LabResult> labs;
  for (const LabResult& lab : progress.labs) {
    if (progress.untouched.count(lab.lab_name) != 0) break;
    labs.push_back(lab);
  }
  return labs;
}

/// Nothing is built for a lab that was not begun, unless it is the next one.
Progress look_at_labs() {
  Progress progress;
  for (const std::string& name : lab_names()) {
    const bool untouched = is_untouched(name);
    if (untouched) progress.untouched.insert(name);
    const bool is_next = !progress.next;
    if (untouched && !is_next) {
      progress.labs.push_back(result_of_starter(name));
      continue;
    }
    if (!remembered_result(name)) say_what_runs("Grading " + title(name));
    progress.labs.push_back(result_of(name));
    if (is_next && !is_finished(progress.labs.back())) progress.next = progress.labs.size() - 1;
  }
  say_what_runs("Running your engine");
  progress.milestones = milestones_reached(begun(progress));
  return progress;
}

/// Twenty cells for 0 to 1; the last one only for all of it.
std::string bar(int part, int whole) {
  constexpr int cells = 20;
  const int full = whole > 0 ? cells * part / whole : 0;
  std::string text;
  for (int i = 0; i < cells; ++i) text += i < full ? '#' : '.';
  return '[' + text + ']';
}

std::string points(int earned, int all) {
  std::ostringstream text;
  text << earned << '/' << all;
  return std::string(std::max<std::size_t>(7, text.str().size()) - text.str().size(), ' ') +
         text.str();
}

std::string remark(const Progress& progress, const LabResult& lab) {
  if (!lab.compile_error.empty()) return coloured("does not compile", Colour::Red);
  if (is_finished(lab)) return coloured("done", Colour::Green);
  if (progress.untouched.count(lab.lab_name) != 0) return coloured("not begun", Colour::Faint);
  return "at " + lab.next_failure()->test.step;
}

/// At most so many lines of a text.
std::string first_lines(const std::string& text, int count) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (count-- == 0) return result + "...\n";
    result += line + '\n';
  }
  return result;
}

/// The second score: do the labs work together?
void print_engine(const Progress& progress) {
  const int reached = static_cast<int>(progress.milestones.size());
  const auto all = static_cast<int>(
      std::count_if(progress.labs.begin(), progress.labs.end(),
                    [](const LabResult& lab) { return has_milestone(lab_number(lab.lab_name)); }));
  std::cout << padded("Your engine, assembled", 27) << bar(reached, all) << points(reached, all)
            << "  milestones";
  for (const LabResult& lab : progress.labs) {
    const int number = lab_number(lab.lab_name);
    if (!has_milestone(number) || progress.milestones.count(number) != 0) continue;
    if (is_finished(lab)) std::cout << "; lab " << number << " --run";
    break;
  }
  std::cout << '\n';
}

void print_labs(const Progress& progress) {
  int earned = 0;
  int all = 0;
  int elsewhere = 0;
  for (const LabResult& lab : progress.labs) {
    std::cout << padded(title(lab.lab_name), 27) << bar(lab.earned(), lab.points())
              << points(lab.earned(), lab.points()) << "  " << remark(progress, lab) << '\n';
    earned += lab.earned();
    all += lab.points();
    elsewhere += points_graded_elsewhere(lab.lab_name);
  }
  std::cout << coloured(padded("Together", 27) + bar(earned, all) + points(earned, all),
                        Colour::Bold)
            << (elsewhere > 0 ? "  and " + std::to_string(elsewhere) + " by instructor" : "")
            << '\n';
  print_engine(progress);
}

/// The next step, and what stands in its way.
/// @param lines at most so many of the reason
void print_next(const Progress& progress, int lines) {
  if (!progress.next) {
    std::cout << "\nEvery test passes. To see your engine at work: ./cs550 lab "
              << lab_number(progress.labs.back().lab_name) << " --run\n";
    return;
  }
  const LabResult& lab = progress.labs[*progress.next];
  if (!lab.compile_error.empty()) {
    std::cout << "\nNext: " << coloured(title(lab.lab_name) + " does not compile", Colour::Bold)
              << '\n'
              << first_lines(indented(lab.compile_error, 4), lines);
    return;
  }
  const Verdict failure = *lab.next_failure();
  const Step step = handout_step(lab.lab_name, failure.test.step);
  std::cout << "\nNext: " << coloured(step.tag + ' ' + step.title, Colour::Bold) << "   (labs/"
            << lab.lab_name << "/README.md)\n";
  std::cout << "  " << failure.test.name << ", " << failure.test.points << " points:\n"
            << first_lines(indented(failure.message, 4), lines);
}

/// Every test of the next lab.
void print_tests(const Progress& progress) {
  if (!progress.next) return print_next(progress, 0);
  const LabResult& lab = progress.labs[*progress.next];
  std::cout << coloured(title(lab.lab_name), Colour::Bold) << "\n\n";
  if (!lab.compile_error.empty()) {
    std::cout << indented(lab.compile_error, 2);
    return;
  }
  for (const Verdict& verdict : lab.verdicts) {
    const bool passed = verdict.kind == Verdict::Kind::Passed;
    std::cout << "  "
              << coloured(padded(to_string(verdict.kind), 8), passed ? Colour::Green : Colour::Red)
              << points(verdict.earned(), verdict.test.points) << "  "
              << padded(verdict.test.step, 6) << verdict.test.name << '\n';
  }
}

int print_hint(const Progress& progress) {
  if (!progress.next) {
    print_next(progress, 0);
    return Good;
  }
  const LabResult& lab = progress.labs[*progress.next];
  return show_hint(lab.lab_name, lab.next_failure()->test.step, 0);
}

void print_overview(const Progress& progress) {
  constexpr int lines_of_reason = 9;  // all of it fits into 24 lines
  print_labs(progress);
  print_next(progress, lines_of_reason);
}

constexpr int whole_message = 1000;

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

/// Keys come one by one, unseen, as long as this object lives.
class KeyByKey {
 public:
  KeyByKey() {
    tcgetattr(STDIN_FILENO, &before_);
    termios now = before_;
    now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &now);
  }
  ~KeyByKey() { tcsetattr(STDIN_FILENO, TCSANOW, &before_); }
  KeyByKey(const KeyByKey&) = delete;
  KeyByKey& operator=(const KeyByKey&) = delete;

  /// The next key, or 0 when none comes for a while; 'q' when the terminal is gone.
  static char wait() {
    constexpr int milliseconds = 200;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, milliseconds) <= 0) return 0;
    char key = 'q';
    return read(STDIN_FILENO, &key, 1) == 1 ? key : 'q';
  }

 private:
  termios before_{};
};

void clear_screen() { std::cout << "\033[H\033[2J\033[3J"; }

void answer(char key, const Progress& progress) {
  clear_screen();
  switch (key) {
    case 'h':
      print_hint(progress);
      break;
    case 'n':
      print_next(progress, whole_message);
      break;
    case 'l':
      print_tests(progress);
      break;
    default:
      print_overview(progress);
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
  Progress progress = look_at_labs();
  answer('r', progress);
  while (true) {
    char key = KeyByKey::wait();
    if (key == 'q') break;
    auto now = times_of_saving();
    if (now != saved) key = 'r';
    if (key == 'r') {
      saved = std::move(now);
      progress = look_at_labs();
    }
    if (key != 0) answer(key, progress);
  }
  std::cout << '\n';
  return Good;
}

int run_progress(const ProgressOptions& options) {
  if (options.watch) return watch();
  const Progress progress = look_at_labs();
  if (isatty(STDERR_FILENO) != 0) std::cerr << '\r' << padded("", 50) << '\r';
  if (options.hint) return print_hint(progress);
  if (options.list) {
    print_tests(progress);
  } else if (options.next) {
    print_next(progress, whole_message);
  } else {
    print_overview(progress);
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
