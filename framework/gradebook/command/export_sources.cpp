#include "gradebook/command/export_sources.hpp"

#include <fmt/format.h>

#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "cli/system/files.hpp"
#include "files/output_file.hpp"
#include "gradebook/intake/discovery.hpp"

namespace cs550::gradebook {

namespace fs = std::filesystem;

void export_sources(const fs::path& root, const std::vector<fs::path>& submissions,
                    const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_empty(folder)) {
    throw std::runtime_error(folder.string() + " is not empty. The export needs a new folder");
  }
  const Catalogue catalogue = read_catalogue(root);
  std::vector<Submission> all;
  std::set<int> labs;
  for (const FoundSubmission& found : find_submissions(submissions, catalogue).submissions) {
    Submission submission = read_submission(found, catalogue);
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
    std::cout << fmt::format(
        "jplag -l cpp -bc {0}/base {0}/submissions\nmoss -l cc -d $(printf -- '-b %s ' {0}/base/*) "
        "{0}/submissions/*/*.cpp\n",
        place.string());
  }
}

}  // namespace cs550::gradebook
