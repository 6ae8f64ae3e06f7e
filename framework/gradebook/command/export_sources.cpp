#include "gradebook/command/export_sources.hpp"

#include <fmt/format.h>

#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "cli/system/files.hpp"
#include "files/output_file.hpp"
#include "gradebook/command/settings.hpp"
#include "gradebook/intake/discovery.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

namespace {

/// The commands for a folder with base/ and submissions/. The shell divides the output of printf at every space, so MOSS
/// runs in that folder, in which no name has one.
void print_commands(const fs::path& folder) {
  std::cout << fmt::format(
      "jplag -l cpp -bc {} {}\n(cd {} && moss -l cc -d $(printf -- '-b %s ' base/*) "
      "submissions/*/*.cpp)\n",
      in_shell(folder / "base"), in_shell(folder / "submissions"), in_shell(folder));
}

}  // namespace

void export_sources(const fs::path& root, const std::vector<fs::path>& submissions,
                    const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_empty(folder)) {
    throw std::runtime_error(folder.string() + " is not empty. The export needs a new folder");
  }
  const Catalogue catalogue = read_catalogue(root);
  std::vector<Submission> all;
  std::set<int> labs;
  const Discovery found = find_submissions(submissions, catalogue);
  print_skipped(found);
  for (const FoundSubmission& source : found.submissions) {
    Submission submission = read_submission(source, catalogue);
    if (!submission.trouble.empty()) {
      std::cout << fmt::format("unreadable: {}: {}\n", submission.name, submission.trouble);
    }
    for (const auto& [number, files] : submission.labs) labs.insert(number);
    all.push_back(std::move(submission));
  }
  check_starters(root, {labs.begin(), labs.end()}, catalogue);
  for (const Submission& submission : all) {
    for (const auto& [number, files] : submission.labs) {
      const fs::path place = folder / fmt::format("lab{}/submissions", number) / submission.name;
      for (const SourceFile& file : files) files::write_file(place / file.path, file.text);
    }
  }
  for (const int number : labs) {
    const CatalogueLab& lab = catalogue.at(number);
    const fs::path place = folder / fmt::format("lab{}", number);
    for (const std::string& file : lab.starter_files) {
      files::write_file(place / "base" / file, cli::read_text(root / "labs" / lab.name / file));
    }
    print_commands(place);
  }
}

}  // namespace cs550::gradebook
