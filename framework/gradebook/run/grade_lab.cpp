#include "gradebook/run/grade_lab.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "files/output_file.hpp"
#include "gradebook/records/record_json.hpp"
#include "gradebook/run/work_folder.hpp"
#include "gradebook/text/escape.hpp"
#include "gradebook/text/sha256.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// Far beyond the limit of a lab, which the judge keeps by itself: one that hangs must not stop the class.
constexpr std::chrono::hours longest_run{2};

constexpr const char* rebuilt =
    "its tests, or the files that they read, were changed during the run; "
    "the same command with --resume grades it again";

void add_limit(std::vector<std::string>& command, const char* option, std::optional<int> value) {
  if (value) command.insert(command.end(), {option, std::to_string(*value)});
}

/// What is added to the seeds of all tests, never 0. The secret cannot be computed from it.
std::string seed_salt(const std::string& secret) {
  constexpr std::size_t digits = 7;
  return std::to_string(1 +
                        std::stoul(sha256_of({"seeds", secret}).substr(0, digits), nullptr, 16));
}

std::vector<std::string> command_for(const CatalogueLab& lab, const Course& course,
                                     const Judge& judge, const fs::path& folder) {
  std::vector<std::string> command{
      judge.program,  std::to_string(lab.is_engine() ? lab.last : lab.number),
      "--submission", folder / "submission",
      "--work",       folder / "work",
      "--results",    folder / "result.json",
      "--isolation",  judge.isolation,
      "--jobs",       std::to_string(judge.jobs)};
  if (lab.is_engine()) command.emplace_back("--milestones");
  if (course.counts_challenges()) command.emplace_back("--challenge");
  if (!course.secret.empty()) command.insert(command.end(), {"--salt", seed_salt(course.secret)});
  const Limits limits = course.limits_of(lab.number);
  add_limit(command, "--wall", limits.wall);
  add_limit(command, "--cpu", limits.cpu);
  add_limit(command, "--memory", limits.memory);
  add_limit(command, "--lab-time", limits.lab);
  return command;
}

/// The judge's result must have exactly the tests of the manifest.
void check_tests(const LabRecord& record, const CatalogueLab& lab) {
  std::set<std::string> missing;
  for (const CatalogueTest& test : lab.tests) missing.insert(test.name);
  for (const TestResult& test : record.tests) {
    if (missing.erase(test.name) == 0) {
      throw std::runtime_error("its result has an unknown test " + test.name);
    }
    if (test.earned < 0 || test.earned > test.points) {
      throw std::runtime_error("its result has impossible points for " + test.name);
    }
  }
  if (!missing.empty()) throw std::runtime_error("its result lacks the test " + *missing.begin());
}

/// Runs the judge to its end. @return what it wrote
std::string result_of(const std::vector<std::string>& command, const fs::path& folder,
                      const std::atomic<bool>& stop) {
  const fs::path output = folder / "output.txt";
  const auto deadline = std::chrono::steady_clock::now() + longest_run;
  const cli::Ending ending = cli::run(
      command, {{}, output, [&] { return stop || std::chrono::steady_clock::now() > deadline; }});
  if (!ending.good()) {
    constexpr std::size_t longest_output = 2000;
    throw std::runtime_error(
        fmt::format("{}\n{}",
                    ending.signal != 0 ? "it was killed by signal " + std::to_string(ending.signal)
                                       : "it exited with code " + std::to_string(ending.exit_code),
                    shortened(cli::read_text(output), longest_output)));
  }
  return cli::read_text(folder / "result.json");
}

/// Whether the student has handed in tests, and the course has points for them.
bool has_own_tests(int lab, const LabFiles& files, const Course& course) {
  return course.lab(lab).own_tests > 0 &&
         std::any_of(files.files.begin(), files.files.end(),
                     [](const SourceFile& file) { return file.path == own_tests_file; });
}

/// Grading the student's own tests. If that fails, the lab keeps its result.
OwnTests run_own_tests(std::vector<std::string> command, const fs::path& folder,
                       const std::atomic<bool>& stop) {
  command.emplace_back("--own-tests");
  try {
    return own_tests_from_judge(result_of(command, folder, stop), "its result");
  } catch (const std::exception& error) {
    OwnTests own;
    own.not_graded = plain_text(error.what());
    return own;
  }
}

LabRecord run_judge(const CatalogueLab& lab, const LabFiles& files, const Course& course,
                    const Judge& judge, const std::atomic<bool>& stop) {
  const WorkFolder folder(judge.work);
  for (const SourceFile& file : files.files) {
    files::write_file(folder.path() / "submission" / file.path, file.text);
  }
  fs::create_directories(folder.path() / "work");
  const std::vector<std::string> command = command_for(lab, course, judge, folder.path());
  LabRecord record = lab_from_judge(result_of(command, folder.path(), stop), "its result");
  check_tests(record, lab);
  if (has_own_tests(lab.number, files, course)) {
    record.own_tests = run_own_tests(command, folder.path(), stop);
  }
  return record;
}

/// Of the contents of files, without those that do not exist.
std::string hash_of(const std::vector<fs::path>& files) {
  std::string hashes;
  for (const fs::path& file : files) {
    if (fs::is_regular_file(file)) hashes += sha256_of({cli::read_text(file)});
  }
  return sha256_of({hashes});
}

std::vector<fs::path> libraries_below(const fs::path& folder) {
  std::vector<fs::path> files = cli::files_below(folder);
  std::erase_if(files, [](const fs::path& file) { return file.extension() != ".so"; });
  return files;
}

/// References, starters and given code, which judges and workers load.
std::vector<fs::path> shared_files(const fs::path& program) {
  const fs::path folder = program.parent_path();
  std::vector<fs::path> files = libraries_below(folder.parent_path() / "labs");
  files.insert(files.end(), {program, folder / "lab_worker"});
  return files;
}

/// Those of a lab alone, or of the engine: 0.
std::vector<fs::path> programs_of(const fs::path& program, int lab) {
  const fs::path folder = program.parent_path();
  if (lab == 0) return {folder / "milestones_judge"};
  const std::string name = fmt::format("lab{}", lab);
  return {folder / (name + "_judge"), folder / (name + "_own_tests")};
}

fs::path mistakes_folder(const fs::path& program, int lab) {
  return program.parent_path().parent_path() / "mistakes" / fmt::format("lab{}", lab);
}

LabRecord without_result(const CatalogueLab& lab, const std::string& status) {
  LabRecord record;
  record.lab = lab.number;
  for (const CatalogueTest& test : lab.tests) {
    record.tests.push_back({test.name, test.step, test.points, 0, status, test.hidden, 0, "", ""});
  }
  return record;
}

}  // namespace

LabFiles files_to_grade(const Submission& submission, const CatalogueLab& lab,
                        const fs::path& starters) {
  LabFiles result;
  if (const auto found = submission.labs.find(lab.number); found != submission.labs.end()) {
    result.files = found->second;
  }
  // A student may have moved the functions of a starter file into another one and deleted it.
  if (submission.whole_labs.contains(lab.number)) return result;
  for (const std::string& name : lab.starter_files) {
    const bool is_there =
        std::any_of(result.files.begin(), result.files.end(),
                    [&name](const SourceFile& file) { return file.path == name; });
    if (is_there) continue;
    result.files.push_back({name, cli::read_text(starters / lab.name / name)});
    result.supplied.push_back(name);
  }
  return result;
}

LabFiles files_of_engine(const Submission& submission, const Catalogue& catalogue,
                         const CatalogueLab& engine, const fs::path& starters) {
  LabFiles result;
  for (const auto& [number, lab] : catalogue) {
    if (number > engine.last) continue;
    const LabFiles files = files_to_grade(submission, lab, starters);
    for (const SourceFile& file : files.files) {
      result.files.push_back({lab.name + '/' + file.path, file.text});
    }
  }
  return result;
}

std::vector<fs::path> files_of_judges(const fs::path& program, const fs::path& root,
                                      const std::vector<int>& labs) {
  std::vector<fs::path> files = shared_files(program);
  const auto add = [&](const std::vector<fs::path>& more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  add(programs_of(program, 0));
  for (const int lab : labs) {
    add(programs_of(program, lab));
    add(libraries_below(mistakes_folder(program, lab)));
  }
  add(cli::files_below(root / "framework/include"));
  add(cli::files_below(root / "framework/assets"));
  return files;
}

std::string stamp_of(const std::vector<fs::path>& files) {
  std::string stamps;
  for (const fs::path& file : files) {
    struct stat facts {};
    if (stat(file.c_str(), &facts) != 0) continue;
    stamps += fmt::format("{} {} {} {}.{}\n", file.string(), facts.st_ino, facts.st_size,
                          facts.st_mtim.tv_sec, facts.st_mtim.tv_nsec);
  }
  return sha256_of({stamps});
}

std::map<int, std::string> versions_of(const fs::path& program, const fs::path& assets,
                                       const std::vector<int>& labs) {
  const std::string all = hash_of(shared_files(program)) + hash_of(cli::files_below(assets));
  std::map<int, std::string> versions{{0, hash_of(programs_of(program, 0))}};
  for (const int lab : labs) versions[lab] = hash_of(programs_of(program, lab));
  for (auto& [lab, version] : versions) version += all;
  return versions;
}

std::map<int, std::string> mistakes_of(const fs::path& program, const std::vector<int>& labs,
                                       const Course& course) {
  std::map<int, std::string> mistakes;
  for (const int lab : labs) {
    if (course.lab(lab).own_tests == 0) continue;
    mistakes[lab] = hash_of(libraries_below(mistakes_folder(program, lab)));
  }
  return mistakes;
}

std::string result_key(int lab, const LabFiles& files, const Course& course, const Judge& judge) {
  const Limits limits = course.limits_of(lab);
  const auto number = [](std::optional<int> value) { return std::to_string(value.value_or(0)); };
  std::vector<std::string> parts{std::to_string(lab), judge.project,         judge.versions.at(lab),
                                 judge.isolation,     course.secret,         number(limits.wall),
                                 number(limits.cpu),  number(limits.memory), number(limits.lab)};
  if (has_own_tests(lab, files, course)) {
    parts.insert(parts.end(), {"own tests", judge.mistakes.at(lab)});
  }
  if (course.counts_challenges()) parts.emplace_back("challenge");
  for (const SourceFile& file : files.files) {
    parts.push_back(file.path);
    parts.push_back(file.text);
  }
  return fmt::format("lab{}-{}", lab, sha256_of({parts.begin(), parts.end()}));
}

std::string recorded_seed(const Course& course) {
  return course.secret.empty() ? "published" : "salt " + seed_salt(course.secret);
}

LabRecord grade_lab(const CatalogueLab& lab, const LabFiles& files, const Course& course,
                    const Judge& judge, const std::atomic<bool>& stop) {
  const auto is_rebuilt = [&] { return stamp_of(judge.files) != judge.stamp; };
  if (is_rebuilt()) return not_graded(lab, rebuilt);
  try {
    LabRecord record = run_judge(lab, files, course, judge, stop);
    return is_rebuilt() ? not_graded(lab, rebuilt) : record;
  } catch (const std::exception& error) {
    return not_graded(lab, fmt::format("{} failed: {}", judge.program.filename().string(),
                                       plain_text(error.what())));
  }
}

LabRecord not_submitted(const CatalogueLab& lab) { return without_result(lab, "not_submitted"); }

LabRecord not_graded(const CatalogueLab& lab, const std::string& reason) {
  LabRecord record = without_result(lab, "not_graded");
  record.not_graded = reason;
  return record;
}

}  // namespace cs550::gradebook
