#pragma once
/// @file catalogue.hpp
/// What can be graded: the labs and their tests, from the manifests of the instructor's copy.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cs550::gradebook {

/// Students' own tests of a lab, beside its files.
inline constexpr const char* own_tests_file = "my_tests.cpp";

struct CatalogueTest {
  std::string name;  ///< "Lab3.FirstOfEqualVerticesWins"
  std::string step;  ///< "L3.1"
  int points = 0;
  bool hidden = false;
};

struct CatalogueLab {
  int number = 0;     ///< 0: an engine, made by engine_of()
  int last = 0;       ///< the last lab of an engine
  std::string name;   ///< folder, "lab3_hill_climbing"
  std::string title;  ///< "Lab 3: hill climbing"
  std::vector<CatalogueTest> tests;
  std::vector<std::string> starter_files;  ///< "hill_climbing.cpp", relative to the lab's folder
  std::vector<std::string> milestones;     ///< "Milestone.lab3_ghosts"

  bool is_engine() const { return number == 0; }
};

/// Labs by number.
using Catalogue = std::map<int, CatalogueLab>;

/// Reads tests/labN_topic/manifest.json, labs/labN_topic/ and the records of milestones below the root of
/// the project.
/// Throws std::runtime_error if a manifest cannot be read.
Catalogue read_catalogue(const std::filesystem::path& root);

/// Throws std::runtime_error if code in the folder of a lab in labs/ differs from Git's last commit,
/// which has the starter: submissions would be graded with it. In a clone where Git cannot tell, it
/// prints why; without Git's history nothing is checked.
void check_starters(const std::filesystem::path& root, const std::vector<int>& labs,
                    const Catalogue& catalogue);

/// The same for Git's index, which --gradescope-zip packs. Throws also where Git cannot tell.
void check_starters_in_index(const std::filesystem::path& root, const std::vector<int>& labs,
                             const Catalogue& catalogue);

/// Labs 1 to `last` together, whose tests are their milestones. A milestone has no points.
CatalogueLab engine_of(const Catalogue& catalogue, int last);

}  // namespace cs550::gradebook
