#include "gradebook/command/grade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "files/interruption.hpp"
#include "gradebook/command/gradescope_upload.hpp"
#include "gradebook/command/settings.hpp"
#include "gradebook/marks/mark.hpp"
#include "gradebook/reports/write_reports.hpp"
#include "gradebook/run/class_run.hpp"
#include "gradebook/run/reference_check.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// The commit of the instructor's copy, marked if files differ from it.
std::string project_version(const fs::path& root) {
  try {
    const std::string commit = cli::output_of({"git", "rev-parse", "HEAD"}, root).substr(0, 40);
    return cli::has_uncommitted_changes(root) ? commit + "+changes" : commit;
  } catch (const std::exception&) {
    return "unknown";
  }
}

/// The program that was named, else the project's own, which is built if it is not up to date.
fs::path judge_of(const GradeRequest& request) {
  if (!request.judge.empty()) return request.judge;
  if (!cli::build("test", "judges")) {
    throw std::runtime_error("the judges could not be built. The messages above have the reason.");
  }
  return cli::built_program("test", "grade_lab");
}

/// The isolation of submissions on this machine. @throws std::runtime_error if it does not work, or
/// would not keep a submission from stealing points
std::string isolation_in_force(const fs::path& judge, const std::string& wanted) {
  std::string kind = cli::output_of({judge, "--probe", wanted});
  while (!kind.empty() && kind.back() == '\n') kind.pop_back();
  return kind;
}

std::vector<int> numbers_of(const Catalogue& catalogue) {
  std::vector<int> numbers;
  for (const auto& [number, lab] : catalogue) numbers.push_back(number);
  return numbers;
}

/// "1 lab", "2 labs".
std::string counted(int number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

/// What a run leaves for the instructor to look at.
void print_troubles(const std::vector<Record>& records) {
  for (const Record& record : records) {
    if (!record.trouble.empty()) {
      std::cout << fmt::format("unreadable: {}: {}\n", record.name, record.trouble);
    }
    if (record.engine && !record.engine->not_graded.empty()) {
      std::cout << fmt::format("no milestones: {}: {}\n", record.name, record.engine->not_graded);
    }
    if (const int late = record.engine ? record.engine->tests_with("timeout") : 0; late > 0) {
      std::cout << fmt::format("timeout: {}: {} ended at the limit of time\n", record.name,
                               counted(late, "milestone"));
    }
    for (const LabRecord& lab : record.labs) {
      if (!lab.not_graded.empty()) {
        std::cout << fmt::format("NOT GRADED: {}, lab {}: {}\n", record.name, lab.lab,
                                 lab.not_graded);
      }
      if (lab.own_tests && !lab.own_tests->not_graded.empty()) {
        std::cout << fmt::format("my_tests.cpp NOT GRADED: {}, lab {}: {}\n", record.name, lab.lab,
                                 lab.own_tests->not_graded);
      }
      if (lab.own_tests && lab.own_tests->stopped) {
        std::cout << fmt::format("timeout: {}, lab {}: {}my_tests.cpp was stopped\n", record.name,
                                 lab.lab, lab.own_tests->compiled ? "" : "the compiler of ");
      }
      if (const int late = lab.tests_with("timeout"); late > 0) {
        std::cout << fmt::format("timeout: {}, lab {}: {} ended at the limit of time\n",
                                 record.name, lab.lab, counted(late, "test"));
      }
    }
  }
}

/// A file that exceeds a size limit is an error of the write instead of a signal. This is a handler
/// and not SIG_IGN, which programs that we start would inherit.
void make_full_disk_an_error() {
  struct sigaction action {};
  action.sa_handler = [](int) {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGXFSZ, &action, nullptr);
}

/// A folder that is removed at the end of a run, whichever way it ends.
class Temporary {
 public:
  explicit Temporary(fs::path folder) : folder_(std::move(folder)) {}
  ~Temporary() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

 private:
  fs::path folder_;
};

void print_outcome(const ClassOutcome& outcome, std::chrono::duration<double> time) {
  std::cout << fmt::format("{}, {} graded in {:.0f} s, {} reused.\n",
                           counted(outcome.submissions, "submission"), counted(outcome.runs, "lab"),
                           time.count(), counted(outcome.known, "result"));
}

/// Refuses an output folder in a folder of submissions: the next run would take its files as submissions.
void check_place(const fs::path& out, const std::vector<fs::path>& submissions) {
  const fs::path place = fs::weakly_canonical(fs::absolute(out));
  for (const fs::path& submission : submissions) {
    if (!fs::is_directory(submission)) continue;
    const fs::path folder = fs::canonical(submission);
    const auto end = std::mismatch(folder.begin(), folder.end(), place.begin(), place.end()).first;
    if (end != folder.end()) continue;
    throw std::invalid_argument(
        fmt::format("--out {} is in the folder of submissions {}.\n"
                    "  Its files would be taken as submissions. Choose a folder outside it.",
                    out.string(), submission.string()));
  }
}

/// Refuses another secret than that of the run that is resumed: part of the class would have other seeds. The
/// records have the seeds; the course file in the folder may be that of a later report.
void check_secret(const Settings& settings, const GradeRequest& request) {
  if (!request.resume) return;
  const std::string seed = recorded_seed(settings.course);
  for (const Record& record : RecordFolder(request.out).records()) {
    for (const LabRecord& lab : record.labs) {
      if (lab.seed.empty() || lab.seed == seed) continue;
      throw std::invalid_argument(request.out.string() +
                                  " was graded with another secret, so with other seeds.\n"
                                  "  Name the course file of that run, or choose another --out.");
    }
  }
}

/// Refuses to replace records, or to remove marks: a resumed run replaces the records that its submissions have, with
/// the labs that it grades.
void check_records(const RecordFolder& folder, const std::vector<int>& labs,
                   const GradeRequest& request) {
  if (!request.resume && folder.has_records()) {
    throw std::runtime_error(request.out.string() + " has records already.\n" +
                             "  To continue an interrupted run, or to add submissions, add " +
                             "--resume.\n  To grade everything again, choose another --out.");
  }
  for (const int lab : labs_of(folder.records())) {
    if (std::count(labs.begin(), labs.end(), lab) > 0) continue;
    throw std::invalid_argument(
        fmt::format("{} has marks of lab {}, which --labs leaves out: --resume would remove them.\n"
                    "  Add lab {} to --labs, or choose another --out.",
                    request.out.string(), lab, lab));
  }
}

}  // namespace

std::vector<int> parse_labs(const std::string& text, const std::vector<int>& known) {
  if (text.empty()) return known;
  static const std::regex range("([0-9]{1,3})(?:-([0-9]{1,3}))?");
  std::set<int> labs;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    std::smatch match;
    if (!std::regex_match(part, match, range)) {
      throw std::invalid_argument("--labs needs numbers such as 3, 1-7 or 1,3-5; found " + text);
    }
    const int first = std::stoi(match[1]);
    const int last = match[2].matched ? std::stoi(match[2]) : first;
    if (last < first) {
      throw std::invalid_argument(fmt::format(
          "--labs needs the lower number of a range first: {}-{}; found {}", last, first, text));
    }
    for (int lab = first; lab <= last; ++lab) labs.insert(lab);
  }
  for (const int lab : labs) {
    if (std::count(known.begin(), known.end(), lab) == 0) {
      throw std::invalid_argument(fmt::format("there is no lab {}. The labs are {} to {}.", lab,
                                              known.front(), known.back()));
    }
  }
  return {labs.begin(), labs.end()};
}

bool grade(const GradeRequest& request) {
  check_place(request.out, request.submissions);
  files::watch_for_interruption();
  const std::atomic<bool>& stop = files::interrupted();
  make_full_disk_an_error();
  const Settings settings = read_settings(request.root, request.course, request.roster,
                                          request.resume ? request.out : fs::path());
  check_secret(settings, request);
  const std::vector<int> labs = parse_labs(request.labs, numbers_of(settings.catalogue));
  if (request.milestones.value_or(false) && labs.front() != 1) {
    throw std::invalid_argument("--milestones needs lab 1 in --labs: an engine begins with it");
  }
  Discovery found = find_submissions(request.submissions, settings.catalogue);
  if (found.submissions.empty()) throw std::runtime_error("no submission was found");
  print_skipped(found);
  std::cout << std::flush;  // a log should have this before the run, which may take an hour

  if (!request.metadata.empty()) {
    found.submissions = {
        gradescope_upload(found.submissions, request.metadata, settings.catalogue)};
  }

  const RecordFolder folder(request.out);
  check_records(folder, labs, request);
  check_starters(request.root, labs, settings.catalogue);
  const fs::path program = judge_of(request);
  const std::string isolation = isolation_in_force(program, request.isolation);
  const FolderLock lock(request.out);
  check_records(folder, labs, request);  // another grader may have finished meanwhile
  keep_settings(settings, request.out);
  folder.begin_run();
  const std::vector<fs::path> files = files_of_judges(program, request.root, labs);
  const Judge judge{program,
                    request.root / "labs",
                    fs::absolute(request.out) / "work",
                    project_version(request.root),
                    isolation,
                    files,
                    stamp_of(files),
                    versions_of(program, request.root / "framework/assets", labs),
                    mistakes_of(program, labs, settings.course),
                    request.jobs};
  std::optional<Temporary> work(judge.work);
  const auto start = std::chrono::steady_clock::now();
  // Where the solutions have been removed (gradescope/setup.sh), the reference has been graded
  // before.
  if (!settings.course.secret.empty() && fs::exists(request.root / "solutions")) {
    std::cout << "Grading the reference with the seeds of this course's secret …\n";
    check_reference(request.root / "solutions", labs, request.jobs, settings.catalogue,
                    settings.course, judge, folder, stop);
  }
  std::optional<cli::ProgressBar> bar;
  const bool milestones = request.milestones.value_or(settings.course.milestones_weight > 0);
  const ClassRun run{std::move(found.submissions), labs, milestones, request.jobs,
                     [&bar](int done, int total) {
                       if (!bar && total > 0) bar.emplace(total, "lab");
                       if (bar) bar->show(done);
                     }};
  const ClassOutcome outcome =
      grade_class(run, settings.catalogue, settings.course, judge, folder, stop);
  bar.reset();
  work.reset();
  if (outcome.interrupted) {
    std::cout << fmt::format("Interrupted after {}. The same command with --resume continues.\n",
                             counted(outcome.runs, "lab"));
    return false;
  }
  folder.end_run();
  print_outcome(outcome, std::chrono::steady_clock::now() - start);
  const std::vector<Record> records = folder.records();
  write_reports(request.out, records, settings.roster, settings.course);
  print_troubles(records);
  print_students_to_look_at(settings, records);
  print_entries_about_nobody(settings, records);
  print_expired(folder, settings.course);
  std::cout << fmt::format("Isolation of submissions: {}.\n", isolation);
  std::cout << fmt::format("The marks are in {}, the overview in {}.\n",
                           (request.out / "grades.csv").string(),
                           (request.out / "class.html").string());
  return std::all_of(records.begin(), records.end(),
                     [](const Record& record) { return record.is_graded(); });
}

}  // namespace cs550::gradebook
