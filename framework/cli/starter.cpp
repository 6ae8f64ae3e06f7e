// ./cs550 starter DIR: the copy that students get, or its update.
#include <iostream>
#include <memory>

#include "draft_folder.hpp"
#include "process.hpp"
#include "project.hpp"
#include "students_copy.hpp"
#include "verb.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

struct StarterOptions {
  fs::path folder;
  int released = 0;
  bool update = false;
};

int refuse(const std::string& why) {
  std::cerr << "cs550: " << why << '\n';
  return Misused;
}

void warn_of_uncommitted_changes() {
  if (!output_of({"git", "status", "--porcelain", "--untracked-files=no"}, project_root())
           .empty()) {
    std::cerr << "There are changes that are not committed: they are not in the copy.\n";
  }
}

int make_copy(const StarterOptions& options, const fs::path& folder) {
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder))) {
    return refuse(folder.string() +
                  " exists and is not empty. To renew a students' copy: --update");
  }
  const DraftFolder draft(folder);
  write_students_copy(draft.path(), options.released);
  start_history(draft.path());
  fs::rename(draft.path(), folder);
  warn_of_uncommitted_changes();
  std::cout << "The students' copy is in " << folder.string() << ": "
            << files_of_copy(folder).size() << " files, one commit.\n";
  return Good;
}

int renew_copy(const StarterOptions& options, const fs::path& folder) {
  if (!fs::exists(folder / ".starters/files.txt")) {
    return refuse(folder.string() + " is no students' copy: it has no .starters/files.txt");
  }
  const DraftFolder draft(folder);
  write_students_copy(draft.path(), options.released);
  const CopyUpdate update = update_copy(folder, draft.path());
  warn_of_uncommitted_changes();
  std::cout << "Files replaced: " << update.files_replaced
            << "; changed lab files kept: " << update.kept.size() << ". Nothing was committed.\n";
  for (const std::string& file : update.conflicts) {
    std::cout << "conflict: " << file << " was changed here, and its starter is a new one:\n"
              << "          compare it with .starters/"
              << fs::path(file).lexically_relative("labs").string() << '\n';
  }
  return update.conflicts.empty() ? Good : Failed;
}

int run_starter(const StarterOptions& options) {
  if (!fs::exists(project_root() / "solutions") || fs::exists(project_root() / ".starters")) {
    return refuse("this is a students' copy already: make one where the solutions are");
  }
  const fs::path folder = fs::absolute(options.folder / "").lexically_normal().parent_path();
  return options.update ? renew_copy(options, folder) : make_copy(options, folder);
}

}  // namespace

Action declare_starter(CLI::App& app) {
  const auto options = std::make_shared<StarterOptions>();
  app.add_option("DIR", options->folder, "where the copy goes: a new or an empty folder")
      ->required();
  app.add_option("--release-solutions", options->released, "with the solutions of labs 1 to K")
      ->check(CLI::Range(0, 99));
  app.add_flag("--update", options->update,
               "renew the students' copy in DIR; lab files that were changed stay as they are");
  return [options] { return run_starter(*options); };
}

}  // namespace cs550::cli
