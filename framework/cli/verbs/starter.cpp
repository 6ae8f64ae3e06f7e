// ./cs550 starter DIR: makes the students' copy of this repository, or updates one.
//
// A students' copy is the last commit without what .gitattributes marks as export-ignore, with its
// starters also in .starters/, which --reset and --update compare with. Solutions are added for labs
// 1..K only, docs/rebuild with that of lab 7, and manifests list the visible tests. An update keeps the solutions
// that a copy has.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "cli/command_line.hpp"
#include "cli/system/draft_folder.hpp"
#include "cli/system/files.hpp"
#include "cli/system/process.hpp"
#include "cli/system/project.hpp"
#include "cli/verb.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"
#include "files/path_argument.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* students_readme = "framework/cli/students_readme.md";
constexpr const char* classroom_workflow = "framework/cli/classroom/workflow.yml";
/// Scripts keep their line ends where git would write those of Windows.
constexpr const char* students_gitattributes = "* text=auto eol=lf\n";
constexpr const char* file_list = ".starters/files.txt";
/// The book's figures: where ./cs550 docs draws them, and where the chapters of a copy look for them.
constexpr const char* drawn_figures = "build/docs/figures";
constexpr const char* copied_figures = "docs/chapters/figures";

struct StarterOptions {
  fs::path folder;
  std::optional<int> released;  ///< without it none, or as many as the copy has already
  bool update = false;
};

// --- making a copy -------------------------------------------------------------------------------

/// Unpacks a tree of the last commit into a folder: an uncommitted experiment of an instructor does
/// not become a starter.
void unpack(const std::string& tree, const fs::path& folder) {
  const fs::path archive = folder / "commit.tar";
  fs::create_directories(folder);
  try {
    output_of({"git", "archive", "--format=tar", "-o", archive, tree}, project_root());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the students' copy is made from a git commit. " +
                             std::string(error.what()));
  }
  output_of({"cmake", "-E", "tar", "xf", archive}, folder);
  fs::remove(archive);
  files::throw_if_interrupted();
}

/// The scripts in docs/rebuild compute stages of labs 4, 5 and 7.
constexpr int last_rebuilt_lab = 7;

void add_solutions(const fs::path& folder, int released) {
  for (const std::string& name : lab_names()) {
    if (lab_number(name) <= released) unpack("HEAD:solutions/" + name, folder / "solutions" / name);
  }
  if (released >= last_rebuilt_lab) unpack("HEAD:docs/rebuild", folder / "docs/rebuild");
}

void list_visible_tests_only(const fs::path& folder) {
  for (const std::string& name : lab_names()) {
    const fs::path manifest = folder / "tests" / name / "manifest.json";
    if (!fs::exists(manifest)) continue;
    Json json = Json::parse(read_text(manifest));
    Json visible = Json::array();
    for (const Json& test : json.at("tests")) {
      if (!test.at("hidden")) visible.push_back(test);
    }
    json["tests"] = visible;
    files::write_file(manifest, json.dump(2) + '\n');
  }
}

void keep_starters(const fs::path& folder) {
  for (const fs::path& file : files_below(folder / "labs")) {
    if (file.extension() != ".cpp") continue;
    const fs::path kept = folder / ".starters" / fs::relative(file, folder / "labs");
    fs::create_directories(kept.parent_path());
    fs::copy_file(file, kept);
  }
}

/// The book's figures, so that its chapters can be read as they are. They are not committed: a copy has
/// them if the book was built here. If it was not, an update keeps those that the copy has.
void add_figures(const fs::path& folder, const fs::path& old_copy) {
  const fs::path drawn = project_root() / drawn_figures;
  const fs::path figures = fs::exists(drawn) ? drawn : old_copy / copied_figures;
  if (fs::exists(figures)) fs::copy(figures, folder / copied_figures);
}

void warn_of_missing_figures(const fs::path& folder) {
  if (fs::exists(project_root() / drawn_figures)) return;
  std::cout << (fs::exists(folder / copied_figures) ? "It keeps the figures that it had."
                                                    : "Its chapters have no figures.")
            << " ./cs550 docs draws them, and then\n"
            << fmt::format("./cs550 starter --update '{}'\nadds them.\n", folder.string());
}

void record_version(const fs::path& folder) {
  const std::string commit = output_of({"git", "rev-parse", "--short=12", "HEAD"}, project_root());
  files::write_file(folder / starter_version_file, fmt::format("{} {}", CS550_VERSION, commit));
}

void list_files(const fs::path& folder) {
  std::string text;
  for (const fs::path& file : files_below(folder)) {
    text += fs::relative(file, folder).string() + '\n';
  }
  files::write_file(folder / file_list, text);
}

/// @param old_copy the one that is updated; empty for a new one
void write_students_copy(const fs::path& folder, int released, const fs::path& old_copy) {
  unpack("HEAD", folder);
  add_solutions(folder, released);
  list_visible_tests_only(folder);
  fs::rename(folder / students_readme, folder / "README.md");
  files::write_file(folder / ".gitattributes", students_gitattributes);
  add_figures(folder, old_copy);
  // Here it would run in the instructors' repository.
  fs::create_directories(folder / ".github/workflows");
  fs::rename(folder / classroom_workflow, folder / ".github/workflows/labs.yml");
  keep_starters(folder);
  record_version(folder);
  list_files(folder);
}

/// Gives the copy a history of its own: one commit by CS550.
void start_history(const fs::path& folder) {
  output_of({"git", "init", "-q", "--initial-branch=main", "--template="}, folder);
  output_of({"git", "add", "--all"}, folder);
  output_of({"git", "-c", "user.name=CS550", "-c", "user.email=cs550@localhost", "-c",
             "commit.gpgSign=false", "commit", "-q", "-m", "The seven labs"},
            folder);
}

// --- updating one --------------------------------------------------------------------------------

/// What an update did.
struct CopyUpdate {
  std::vector<std::string> added, replaced, removed;
  std::vector<std::string> kept;       ///< lab files that the student has changed
  std::vector<std::string> conflicts;  ///< among them, those whose starter has changed as well
};

/// The files that a copy lists as its own, relative to it.
std::vector<std::string> files_of_copy(const fs::path& copy) {
  std::istringstream lines(read_text(copy / file_list));
  std::vector<std::string> files;
  for (std::string line; std::getline(lines, line);) files.push_back(line);
  std::sort(files.begin(), files.end());  // paths sort otherwise: a/b before a.b
  return files;
}

/// The last lab whose solution a copy has; 0 if it has none.
int last_released_lab(const fs::path& copy) {
  int last = 0;
  for (const std::string& file : files_of_copy(copy)) {
    for (const std::string& name : lab_names()) {
      if (file.starts_with("solutions/" + name + '/')) last = std::max(last, lab_number(name));
    }
  }
  return last;
}

void print_released_solutions(const fs::path& copy) {
  const int last = last_released_lab(copy);
  std::cout << (last == 0   ? "It has no solutions.\n"
                : last == 1 ? "It has the solution of lab 1.\n"
                            : fmt::format("It has the solutions of labs 1 to {}.\n", last));
}

bool is_lab_file(const fs::path& path) {
  return *path.begin() == "labs" && path.extension() == ".cpp";
}

fs::path starter_path(const fs::path& lab_file) {
  return fs::path(".starters") / lab_file.lexically_relative("labs");
}

bool same_text(const fs::path& a, const fs::path& b) {
  return fs::exists(a) && fs::exists(b) && read_text(a) == read_text(b);
}

/// An interrupted update leaves no half-written file. The copy has the permissions of the fresh one.
void replace(const fs::path& file, const fs::path& fresh) {
  files::copy_file(fresh, file);
  fs::permissions(file, fs::status(fresh).permissions());
}

/// Replaces the lab files that still are the copy's starters. The others are never touched. A new one is left
/// from an update that ended before it replaced the starter.
void update_lab_file(const std::string& file, const fs::path& copy, const fs::path& fresh,
                     CopyUpdate& update) {
  if (same_text(copy / file, fresh / file)) return;
  if (!fs::exists(copy / file) || same_text(copy / file, copy / starter_path(file))) {
    replace(copy / file, fresh / file);
    return;
  }
  update.kept.push_back(file);
  if (!same_text(copy / starter_path(file), fresh / starter_path(file))) {
    update.conflicts.push_back(file);
  }
}

/// Brings a copy up to a fresh one. Files that the fresh one no longer has are removed; the
/// student's own files stay.
CopyUpdate update_copy(const fs::path& copy, const fs::path& fresh) {
  const std::vector<std::string> old_files = files_of_copy(copy);
  const std::vector<std::string> new_files = files_of_copy(fresh);
  CopyUpdate update;
  // Lab files first: the old starters show which were changed.
  for (const std::string& file : new_files) {
    if (is_lab_file(file)) update_lab_file(file, copy, fresh, update);
  }
  for (const std::string& file : new_files) {
    if (is_lab_file(file) || same_text(copy / file, fresh / file)) continue;
    (fs::exists(copy / file) ? update.replaced : update.added).push_back(file);
    replace(copy / file, fresh / file);
  }
  for (const std::string& file : old_files) {
    if (!is_lab_file(file) && !std::binary_search(new_files.begin(), new_files.end(), file)) {
      fs::remove(copy / file);
      update.removed.push_back(file);
    }
  }
  replace(copy / file_list, fresh / file_list);
  return update;
}

// --- the verb ------------------------------------------------------------------------------------

int refuse(const std::string& why) {
  print_error(why);
  return Misused;
}

void warn_of_uncommitted_changes() {
  if (has_uncommitted_changes(project_root())) {
    std::cerr << "Warning: uncommitted changes are not in the copy.\n";
  }
}

void clear_abandoned_drafts(const fs::path& folder) {
  for (const fs::path& draft : remove_abandoned_drafts(folder)) {
    std::cerr << fmt::format("Removed {}, which a killed run had left.\n", draft.string());
  }
}

int make_copy(const StarterOptions& options, const fs::path& folder) {
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder))) {
    return refuse(folder.string() +
                  " exists and is not empty.\n  To update a students' copy, add --update.");
  }
  const DraftFolder draft(folder);
  write_students_copy(draft.path(), options.released.value_or(0), {});
  start_history(draft.path());
  files::throw_if_interrupted();
  fs::rename(draft.path(), folder);
  warn_of_uncommitted_changes();
  std::cout << fmt::format("The students' copy is in {}: version {}, {} files, one commit.\n",
                           folder.string(), starter_version(folder), files_of_copy(folder).size());
  print_released_solutions(folder);
  warn_of_missing_figures(folder);
  return Good;
}

void print_files(const char* what, const std::vector<std::string>& files) {
  for (const std::string& file : files) std::cout << what << ": " << file << '\n';
}

int renew_copy(const StarterOptions& options, const fs::path& folder) {
  if (!fs::exists(folder / file_list)) {
    return refuse(folder.string() + " is not a students' copy: it has no " + file_list);
  }
  const std::string old_version = starter_version(folder);
  const DraftFolder draft(folder);
  write_students_copy(draft.path(),
                      options.released ? *options.released : last_released_lab(folder), folder);
  files::throw_if_interrupted();
  const CopyUpdate update = update_copy(folder, draft.path());
  warn_of_uncommitted_changes();
  print_files("added", update.added);
  print_files("replaced", update.replaced);
  print_files("removed", update.removed);
  std::cout << fmt::format(
      "Updated from version {} to {}: {} files added, {} replaced, {} removed,\n"
      "{} changed lab files kept. Nothing was committed.\n",
      old_version, starter_version(folder), update.added.size(), update.replaced.size(),
      update.removed.size(), update.kept.size());
  print_released_solutions(folder);
  warn_of_missing_figures(folder);
  for (const std::string& file : update.conflicts) {
    std::cout << fmt::format(
        "conflict: {} was changed, and so was its starter.\n"
        "          Compare it with {}.\n",
        file, starter_path(file).string());
  }
  return update.conflicts.empty() ? Good : Failed;
}

/// Why there can be no folder of that name; empty if there can.
std::string fault_of_folder(fs::path folder) {
  std::error_code reason;
  fs::file_status status = fs::status(folder, reason);
  const bool is_new = status.type() == fs::file_type::not_found;
  while (status.type() == fs::file_type::not_found) {
    folder = folder.parent_path();
    status = fs::status(folder, reason);
  }
  if (status.type() == fs::file_type::none) return folder.string() + ": " + reason.message();
  return is_new && !fs::is_directory(status) ? folder.string() + " is not a folder" : "";
}

int run_starter(const StarterOptions& options) {
  if (!fs::exists(project_root() / "solutions") || is_students_copy()) {
    return refuse("this is a students' copy. Run starter in the instructors' repository.");
  }
  const fs::path folder = fs::absolute(options.folder / "").lexically_normal().parent_path();
  if (const std::string fault = fault_of_folder(folder); !fault.empty()) return refuse(fault);
  files::watch_for_interruption();
  clear_abandoned_drafts(folder);
  try {
    return options.update ? renew_copy(options, folder) : make_copy(options, folder);
  } catch (const std::exception&) {
    files::
        throw_if_interrupted();  // Ctrl-C ends git and CMake as well: their failure is not the reason
    throw;
  }
}

}  // namespace

Action declare_starter(CLI::App& app) {
  const auto options = std::make_shared<StarterOptions>();
  app.add_option("DIR", options->folder, "folder of the copy, new or empty")
      ->required()
      ->check(files::fault_of_path);
  app.add_option("--release-solutions", options->released,
                 "include the solutions of labs 1 to K; by default\n"
                 "none, and with --update those that the copy has")
      ->option_text("K")
      ->check(CLI::Range(0, lab_number(lab_names().back())));
  app.add_flag("--update", options->update,
               "update the students' copy in DIR; changed lab files are kept");
  return [options] { return run_starter(*options); };
}

}  // namespace cs550::cli
