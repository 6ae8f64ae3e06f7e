#pragma once
/// @file grade_lab.hpp
/// Grading one lab of one submission, by the judge program.

#include <atomic>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "gradebook/course/catalogue.hpp"
#include "gradebook/course/course.hpp"
#include "gradebook/intake/submission.hpp"
#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// What the grader runs, and where.
struct Judge {
  std::filesystem::path program;             ///< grade_lab
  std::filesystem::path starters;            ///< labs/ of the project
  std::filesystem::path work;                ///< a new folder for each lab is made here
  std::string project;                       ///< commit
  std::string isolation;                     ///< of submissions: bubblewrap or plain
  std::vector<std::filesystem::path> files;  ///< files_of_judges()
  std::string stamp;                         ///< stamp_of() these files when the run began
  std::map<int, std::string> versions;       ///< versions_of() the labs and the engine
  std::map<int, std::string> mistakes;       ///< mistakes_of() the labs
  int jobs = 1;                              ///< judges that run at the same time
};

/// The files of one lab as they are graded.
struct LabFiles {
  std::vector<SourceFile> files;
  std::vector<std::string> supplied;  ///< starter files that the submission lacks
};

LabFiles files_to_grade(const Submission& submission, const CatalogueLab& lab,
                        const std::filesystem::path& starters);

/// The files of the labs of an engine, each in its lab's folder.
LabFiles files_of_engine(const Submission& submission, const Catalogue& catalogue,
                         const CatalogueLab& engine, const std::filesystem::path& starters);

/// The programs and libraries that grade the labs and the engine, the known mistakes, the headers that submissions are
/// compiled with, and the meshes, scenes and trajectories.
/// @param root of the project
std::vector<std::filesystem::path> files_of_judges(const std::filesystem::path& program,
                                                   const std::filesystem::path& root,
                                                   const std::vector<int>& labs);

/// Changes when one of the files is written again. It is faster than a hash of what they hold.
std::string stamp_of(const std::vector<std::filesystem::path>& files);

/// A hash of the programs and libraries that grade each lab, and the engine: 0, with the meshes, scenes and
/// trajectories that they read. The commit does not name them while files differ from it.
std::map<int, std::string> versions_of(const std::filesystem::path& program,
                                       const std::filesystem::path& assets,
                                       const std::vector<int>& labs);

/// A hash of the known mistakes of each lab whose own tests earn points.
std::map<int, std::string> mistakes_of(const std::filesystem::path& program,
                                       const std::vector<int>& labs, const Course& course);

/// Names everything that the result of a lab depends on.
std::string result_key(int lab, const LabFiles& files, const Course& course, const Judge& judge);

/// The seed in the records of labs that are graded in a course.
std::string recorded_seed(const Course& course);

/// Runs the judge of a lab, or of an engine, in a new folder, which is removed afterwards. What went wrong with the grader
/// itself is in `not_graded`, as is a judge that was built again since the run began.
/// @param stop the judge is killed when it becomes true
LabRecord grade_lab(const CatalogueLab& lab, const LabFiles& files, const Course& course,
                    const Judge& judge, const std::atomic<bool>& stop);

/// The record of a lab without files: no point, every test not_submitted.
LabRecord not_submitted(const CatalogueLab& lab);

/// The record of a lab that the grader could not grade.
LabRecord not_graded(const CatalogueLab& lab, const std::string& reason);

}  // namespace cs550::gradebook
