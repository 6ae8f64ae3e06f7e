// ./cs550 submit [N]: packs the lab files into a zip to hand in.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "cli/command_line.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/system/build_log.hpp"
#include "cli/system/draft_folder.hpp"
#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/verb.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"
#include "files/path_argument.hpp"
#include "files/source_name.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

struct SubmitOptions {
  std::optional<int> lab;  ///< empty: every lab that was begun
  fs::path out;
  std::string student;  ///< empty: the name that was given last time
  bool force = false;
};

/// Where the name may be remembered: in the project itself, so that it is asked for once, wherever the project is
/// built; or, if the project cannot be written to, in the folder of links to it.
std::array<fs::path, 2> files_of_name() {
  const fs::path root = project_root();
  return {behind_links(root) / ".student", root / ".student"};
}

/// A submission does not need the file. If it cannot be written, a warning is enough.
void remember_name(const std::string& name) {
  std::string last_failure;
  for (const fs::path& file : files_of_name()) {
    try {
      return files::write_file(file, name + '\n');
    } catch (const std::runtime_error& failure) {
      last_failure = failure.what();
    }
  }
  std::cerr << indented("Warning: the name is not remembered: " + last_failure, 0);
}

std::string remembered_name() {
  std::string name;
  for (const fs::path& file : files_of_name()) {
    std::ifstream stored(file);
    if (std::getline(stored, name)) return name;
  }
  return "";
}

/// The student's name; empty if it is not known and nobody can be asked.
std::string student_name(const std::string& given) {
  const std::string known = remembered_name();
  std::string name = given.empty() ? known : given;
  if (name.empty() && isatty(STDIN_FILENO) != 0) {
    std::cerr << "Your name or student number, as your instructor knows it: ";
    std::getline(std::cin, name);
  }
  if (name != known) remember_name(name);
  return name;
}

/// The current time in UTC, in ISO 8601.
std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// A lab that does not compile is packed too: its other files may earn points, and the instructor
/// sees the reason.
void warn_unless_it_compiles(int lab) {
  if (build("student", "lab" + std::to_string(lab) + "_student_code")) return;
  std::cerr << "Warning: lab " << lab
            << (is_students_error(first_build_error())
                    ? " does not compile, so that its tests will fail.\n"
                    : " was not built, so it is not known whether it compiles.\n");
}

/// Names what a lab might need and lacks in the zip file.
void print_files_left_out(const std::string& lab_name) {
  for (const fs::path& file : files_left_out(lab_name)) {
    const fs::path name = file.lexically_relative(project_root());
    if (files::is_source(file)) {
      const std::string renamed = files::plain_name(name);
      std::cerr << "Not packed: " << name.string()
                << "\n  Its name may have letters, digits and _-. only. Rename it to " << renamed
                << ", also where it is included.\n";
    } else {
      std::cerr << "Not packed: " << name.string() << "\n  Code must be in files that end in "
                << files::source_extensions() << ".\n";
    }
  }
}

/// Why a lab has no code to hand in; empty if it has some. Tests of one's own are not enough.
std::string fault_of_code_to_submit(const std::string& lab_name) {
  if (const std::string fault = fault_of_absent_code(lab_name); !fault.empty()) return fault;
  const fs::path folder = project_root() / "labs" / lab_name;  // what is below it is only included
  const std::vector<fs::path> files = files_to_submit(lab_name);
  const bool has_code = std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    return file.parent_path() == folder && file.extension() == ".cpp" &&
           file.filename() != "my_tests.cpp";
  });
  return has_code ? "" : "labs/" + lab_name + " has no .cpp file that can be packed.";
}

Json manifest(const std::vector<std::string>& labs, const std::string& student) {
  Json files = Json::array();
  for (const std::string& name : labs) {
    for (const fs::path& file : files_to_submit(name)) {
      files.push_back({{"lab", lab_number(name)},
                       {"file", file.lexically_relative(project_root()).string()},
                       {"sha256", sha256(file)},
                       {"bytes", fs::file_size(file)}});
    }
  }
  return {{"format", 1},
          {"student", student},
          {"date", date()},
          {"starter", starter_version(project_root())},
          {"files", files}};
}

/// By CMake, so that no other program is needed.
void write_zip(const fs::path& out, const Json& manifest) {
  files::watch_for_interruption();
  const fs::path folder = project_root() / "build/submission";
  remove_abandoned_drafts(folder);
  const DraftFolder stage(folder);
  files::write_file(stage.path() / "manifest.json",
                    manifest.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  std::vector<std::string> command{"cmake",  "-E",           "tar", "cf",
                                   "packed", "--format=zip", "--",  "manifest.json"};
  for (const Json& entry : manifest.at("files")) {
    const fs::path file = entry.at("file").get<std::string>();
    fs::create_directories((stage.path() / file).parent_path());
    fs::copy_file(project_root() / file, stage.path() / file);
    command.push_back(file);
  }
  output_of(command, stage.path());
  files::throw_if_interrupted();
  files::write_file(out, read_text(stage.path() / "packed"));
}

/// The labs to pack: the one asked for, or all that are not the untouched starter.
std::vector<std::string> labs_to_pack(const SubmitOptions& options) {
  if (options.lab) return {lab_name(*options.lab)};
  std::vector<std::string> labs;
  for (const std::string& name : lab_names()) {
    if (options.force || !is_nothing_to_submit(name)) labs.push_back(name);
  }
  return labs;
}

fs::path zip_file(const SubmitOptions& options) {
  if (!options.out.empty()) return options.out;
  return options.lab ? "lab" + std::to_string(*options.lab) + ".zip" : "labs.zip";
}

/// Why no file can be written there; empty when one can.
std::string fault_of(const fs::path& out) {
  std::error_code reason;
  const fs::file_status status = fs::status(out, reason);
  if (status.type() == fs::file_type::none) return out.string() + ": " + reason.message();
  if (fs::is_directory(status))
    return out.string() + " is a folder. --out needs the name of a zip file.";
  const fs::path folder = out.parent_path();
  return folder.empty() || fs::is_directory(folder, reason)
             ? ""
             : "there is no folder " + folder.string() + ". Make it first.";
}

int run_submit(const SubmitOptions& options) {
  const fs::path out = zip_file(options);
  if (const std::string fault = fault_of(out); !fault.empty()) {
    print_error(fault);
    return Misused;
  }
  const std::vector<std::string> labs = labs_to_pack(options);
  if (labs.empty() || (options.lab && !options.force && is_nothing_to_submit(labs.front()))) {
    print_error((labs.empty() ? "every lab" : "lab " + std::to_string(*options.lab)) +
                " is still the unchanged starter.\n  To pack it anyway, add --force.");
    return Failed;
  }
  for (const std::string& name : labs) {
    print_files_left_out(name);
    if (const std::string fault = fault_of_code_to_submit(name); !fault.empty()) {
      print_error(fault);
      return Failed;
    }
  }
  for (const std::string& name : labs) warn_unless_it_compiles(lab_number(name));
  const std::string student = student_name(options.student);
  if (student.empty()) {
    std::cerr << "Warning: the submission has no name. Add one with --student NAME.\n";
  }
  const Json listed = manifest(labs, student);
  write_zip(out, listed);
  for (const Json& file : listed.at("files")) {
    std::cout << file.at("sha256").get<std::string>().substr(0, 12) << "  "
              << file.at("file").get<std::string>() << '\n';
  }
  std::cout << "Wrote " << out.string() << ". Hand in this file.\n";
  return Good;
}

}  // namespace

Action declare_submit(CLI::App& app) {
  const auto options = std::make_shared<SubmitOptions>();
  app.add_option("N", options->lab, "number of the lab; by default every lab that was begun")
      ->transform(plain_lab_number)
      ->check(fault_of_lab_number);
  app.add_option("--out", options->out, "zip file to write; by default labN.zip or labs.zip")
      ->option_text("FILE")
      ->check(files::fault_of_path)
      ->check([](const std::string& file) { return files::fault_of_ending(file, ".zip"); });
  app.add_option("--student", options->student, "your name or student number; it is remembered")
      ->option_text("NAME");
  app.add_flag("--force", options->force, "pack a lab even if it is the unchanged starter");
  return [options] { return run_submit(*options); };
}

}  // namespace cs550::cli
