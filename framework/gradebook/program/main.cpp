// The program behind ./cs550 grade: grades the submissions of a class, and makes reports from records.
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/project.hpp"
#include "files/path_argument.hpp"
#include "gradebook/command/compare.hpp"
#include "gradebook/command/export_sources.hpp"
#include "gradebook/command/grade.hpp"
#include "gradebook/command/gradescope_zip.hpp"
#include "gradebook/command/report.hpp"
#include "gradebook/records/record_folder.hpp"

namespace {

using namespace cs550;
using namespace cs550::cli;
namespace fs = std::filesystem;

struct GradeOptions {
  gradebook::GradeRequest grading;
  std::vector<fs::path> report, compare;
  fs::path export_folder, gradescope_zip;
  bool pseudonyms = false;
};

int print_comparison(const std::vector<fs::path>& folders) {
  std::vector<std::vector<gradebook::Record>> records;
  for (const fs::path& folder : folders) records.push_back(gradebook::records_in(folder));
  std::cout << gradebook::comparison(records[0], records[1]);
  return Good;
}

int make_reports(const GradeOptions& options) {
  const fs::path& out = options.grading.out;
  if (out.empty() && options.report.size() > 1) {
    throw std::invalid_argument("--report with several folders needs --out for the merged records");
  }
  gradebook::report({project_root(), options.report, out.empty() ? options.report.front() : out,
                     options.grading.roster, options.grading.course, options.pseudonyms});
  return Good;
}

int grade_submissions(gradebook::GradeRequest request) {
  if (request.out.empty()) {
    throw std::invalid_argument("grade needs --out DIR, a folder for records and reports");
  }
  request.root = project_root();
  return gradebook::grade(request) ? Good : Failed;
}

int run_grade(const GradeOptions& options) {
  try {
    const bool reads_records = !options.compare.empty() || !options.report.empty();
    if (reads_records && !options.grading.submissions.empty()) {
      throw std::invalid_argument("--report and --compare read records, and take no submissions");
    }
    if (!options.compare.empty()) return print_comparison(options.compare);
    if (!options.report.empty()) return make_reports(options);
    if (options.pseudonyms) {
      throw std::invalid_argument("--pseudonyms needs --report DIR, a folder with records");
    }
    if (!options.gradescope_zip.empty()) {
      gradebook::make_gradescope_zip({project_root(), options.grading.labs, options.grading.course,
                                      options.grading.roster, options.gradescope_zip});
      return Good;
    }
    if (options.grading.submissions.empty()) {
      throw std::invalid_argument("grade needs at least one submission");
    }
    if (options.export_folder.empty()) return grade_submissions(options.grading);
    gradebook::export_sources(project_root(), options.grading.submissions, options.export_folder);
    return Good;
  } catch (const std::invalid_argument& error) {
    std::cerr << "cs550: " << error.what() << "\n  ./cs550 grade --help explains the options.\n";
    return Misused;
  }
}

void add_grading_options(CLI::App& app, gradebook::GradeRequest& request) {
  app.add_option("SUBMISSION", request.submissions,
                 "zip, tar.gz or folder of a student, or a folder of such submissions")
      ->option_text("...")
      ->check(files::fault_of_path);
  app.add_option("--out", request.out, "folder for records and reports")
      ->option_text("DIR")
      ->check(files::fault_of_path);
  app.add_option("--labs", request.labs, "labs to grade, such as 3, 1-7 or 1,3-5; by default all")
      ->option_text("LIST")
      ->check([](const std::string& list) {
        return list.empty() ? std::string("an empty list; leave --labs out for all labs") : "";
      });
  app.add_option("--jobs", request.jobs, "labs graded at the same time; by default one per core")
      ->option_text("N")
      ->check(CLI::Range(1, 256));
  app.add_flag("--resume", request.resume,
               "continue an interrupted run, or add submissions to a finished one");
  app.add_flag_function(
      "--milestones,!--no-milestones",
      [&request](std::int64_t count) { request.milestones = count > 0; },
      "run the milestones, too; by default if the course file gives them a weight");
  app.add_option("--roster", request.roster, "students: CSV with the columns id, name, email")
      ->option_text("CSV")
      ->check(CLI::ExistingFile);
  app.add_option("--course", request.course, "settings of the course: weights, due dates, limits")
      ->option_text("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--gradescope-metadata", request.metadata,
                 "submission_metadata.json of Gradescope: time and student of the upload")
      ->option_text("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--isolation", request.isolation,
                 "bubblewrap, plain, or auto: the best that protects the marks here")
      ->option_text("KIND")
      ->check(CLI::IsMember({"auto", "bubblewrap", "plain"}));
  app.add_option("--judge", request.judge,
                 "program that grades one lab; by default the project's own, built now")
      ->option_text("FILE")
      ->check(CLI::ExistingFile);
}

void declare(CLI::App& app, GradeOptions& options) {
  add_grading_options(app, options.grading);
  app.add_option("--report", options.report,
                 "make all reports again from the records of a folder; several folders are merged")
      ->option_text("DIR...")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--pseudonyms", options.pseudonyms, "with --report: leave out names");
  app.add_option("--compare", options.compare, "print what differs between two folders' records")
      ->option_text("OLD NEW")
      ->expected(2)
      ->check(CLI::ExistingDirectory);
  app.add_option("--export-jplag", options.export_folder,
                 "write the submissions as JPlag and MOSS expect them, and grade nothing")
      ->option_text("FOLDER")
      ->check(files::fault_of_path);
  app.add_option("--gradescope-zip", options.gradescope_zip,
                 "write the autograder of --labs for Gradescope, with --course and --roster")
      ->option_text("FILE")
      ->check(files::fault_of_path);
}

}  // namespace

int main(int argc, char** argv) {
  GradeOptions options;
  options.grading.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App app("Grade the submissions of a class", "./cs550 grade");
  declare(app, options);
  return run_verb(app, "grade", argc, argv, [&] { return run_grade(options); });
}
