/// Which submissions are in a folder, and whose they are.
#include <gtest/gtest.h>

#include <map>

#include "files/output_file.hpp"
#include "gradebook/intake/discovery.hpp"
#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// Of each submission that is found, by its name.
using Students = std::map<std::string, std::string>;

Students students_in(const std::vector<fs::path>& sources) {
  Students found;
  for (const FoundSubmission& submission :
       find_submissions(sources, project_catalogue()).submissions) {
    found[submission.name] = submission.student;
  }
  return found;
}

/// "notes.txt: not an archive".
std::vector<std::string> notes_on_skipped(const Discovery& found) {
  std::vector<std::string> notes;
  for (const IgnoredFile& file : found.skipped) {
    notes.push_back(fs::path(file.path).filename().string() + ": " + file.reason);
  }
  return notes;
}

TEST(Discovery, AFolderOfSubmissionsIsAllOfThem) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/ada-lab3.zip", "");
  files::write_file(scratch / "class/bob/labs/lab3_hill_climbing/a.cpp", "");
  files::write_file(scratch / "class/eve/lab1.zip", "");
  files::write_file(scratch / "class/eve/lab2.tar.gz", "");
  files::write_file(scratch / "class/list.txt", "");
  fs::create_directory(scratch / "class/empty");
  const Discovery found = find_submissions({scratch / "class/"}, project_catalogue());
  std::vector<std::string> names;
  std::vector<std::string> students;
  for (const FoundSubmission& submission : found.submissions) {
    names.push_back(submission.name);
    students.push_back(submission.student);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"ada-lab3", "bob", "empty", "eve-lab1", "eve-lab2"}));
  EXPECT_EQ(students, (std::vector<std::string>{"ada", "bob", "empty", "eve", "eve"}));
  ASSERT_EQ(found.skipped.size(), 1U);
  const Discovery alone = find_submissions({scratch / "class/empty"}, project_catalogue());
  ASSERT_EQ(alone.submissions.size(), 1U) << "an empty folder that is named gets a record";
  EXPECT_EQ(alone.submissions[0].student, "empty");
  EXPECT_THROW(find_submissions({scratch / "absent"}, project_catalogue()), std::runtime_error);
}

TEST(Discovery, AFolderOfALabMayHoldSubmissionsOfIt) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/ada/lab3/lab3.zip", "");
  files::write_file(scratch / "class/ada/lab4/support.cpp", "");
  files::write_file(scratch / "class/bob/lab3/src/a.cpp", "");
  files::write_file(scratch / "class/eve/lab3/notes.txt", "");
  EXPECT_EQ(students_in({scratch / "class"}),
            (Students{{"ada", "ada"}, {"bob", "bob"}, {"eve", "eve"}}))
      << "a lab beside the archive";
  fs::remove_all(scratch / "class/ada/lab4");
  EXPECT_EQ(students_in({scratch / "class"}),
            (Students{{"ada-lab3-lab3", "ada"}, {"bob", "bob"}, {"eve", "eve"}}));
  for (const char* student : {"ada", "bob"}) {
    files::write_file(scratch / "week/lab3" / (std::string(student) + ".zip"), "");
  }
  EXPECT_EQ(students_in({scratch / "week"}), (Students{{"lab3-ada", "ada"}, {"lab3-bob", "bob"}}));
  files::write_file(scratch / "week/lab3/eve/hill_climbing.cpp", "");
  const Students with_folder{{"lab3-ada", "ada"}, {"lab3-bob", "bob"}, {"lab3-eve", "eve"}};
  EXPECT_EQ(students_in({scratch / "week"}), with_folder) << "a folder beside the archives";
  for (const char* student : {"ada", "bob"}) {
    const fs::path archive = scratch / "week/lab3" / (std::string(student) + ".zip");
    fs::create_directory(scratch / "week/lab3" / student);
    fs::rename(archive, scratch / "week/lab3" / student / "lab3.zip");
  }
  EXPECT_EQ(students_in({scratch / "week"}),
            (Students{{"lab3-ada-lab3", "ada"}, {"lab3-bob-lab3", "bob"}, {"lab3-eve", "eve"}}))
      << "a folder per student";
}

TEST(Discovery, InTheDeepestFoldersEverythingIsFoundOrListed) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/week3/lab3/s0101.zip", "");
  files::write_file(scratch / "class/week3/lab3/s0102/hill_climbing.cpp", "");
  files::write_file(scratch / "class/week3/lab3/s0103/lab3.zip", "");
  files::write_file(scratch / "class/week3/lab3/notes.txt", "");
  fs::create_symlink(scratch / "class", scratch / "class/week3/lab3/link");
  const Discovery found = find_submissions({scratch / "class"}, project_catalogue());
  std::vector<std::string> names;
  for (const FoundSubmission& submission : found.submissions) names.push_back(submission.name);
  EXPECT_EQ(names, (std::vector<std::string>{"week3-lab3-s0101", "week3-lab3-s0102"}));
  EXPECT_EQ(notes_on_skipped(found),
            (std::vector<std::string>{"link: a symbolic link, which is not followed",
                                      "notes.txt: not an archive",
                                      "s0103: its archives are too deep: not read"}));
}

TEST(Discovery, SeveralSubmissionsThatAreTooDeepAreListed) {
  const ScratchFolder scratch;
  for (const char* student : {"sectionA/s0101", "sectionA/s0102", "sectionB/s0103"}) {
    files::write_file(scratch / "class/week3/monday" / student / "labs/lab3_hill_climbing/a.cpp",
                      "");
  }
  EXPECT_EQ(notes_on_skipped(find_submissions({scratch / "class"}, project_catalogue())),
            (std::vector<std::string>{"s0101: too deep to be a submission of its own",
                                      "s0102: too deep to be a submission of its own",
                                      "s0103: too deep to be a submission of its own"}));
}

TEST(Discovery, AnArchiveBesideTheCodeIsListedHoweverDeepItIs) {
  const ScratchFolder scratch;
  const fs::path upload = scratch / "class/s0101/hand-in";
  files::write_file(upload / "code/cs550-main/labs/lab3_hill_climbing/a.cpp", "");
  files::write_file(upload / "more/a/b/lab4.zip", "");
  const Discovery found = find_submissions({scratch / "class"}, project_catalogue());
  ASSERT_EQ(found.submissions.size(), 1U);
  EXPECT_TRUE(read_submission(found.submissions[0], project_catalogue()).labs.contains(3));
  EXPECT_EQ(notes_on_skipped(found),
            std::vector<std::string>{"b: its archives are too deep: not read"});
}

TEST(Discovery, WhatIsGradedIsNotSkipped) {
  const ScratchFolder scratch;
  const std::string project = "class/s0101/hand-in/project/cs550-main";
  files::write_file(scratch / project / "labs/lab3_hill_climbing/hill_climbing.cpp", "");
  const Discovery found = find_submissions({scratch / "class"}, project_catalogue());
  ASSERT_EQ(found.submissions.size(), 1U);
  EXPECT_TRUE(read_submission(found.submissions[0], project_catalogue()).labs.contains(3));
  EXPECT_TRUE(found.skipped.empty()) << found.skipped[0].path << ": " << found.skipped[0].reason;
}

TEST(Discovery, AnArchiveNamedLikeALabIsThatOfItsFolder) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/eve/lab1.zip", "");
  files::write_file(scratch / "class/max/labs.zip", "");
  files::write_file(scratch / "class/s0101/lab3/lab3.zip", "");
  files::write_file(scratch / "class/zoe/lab3/hill_climbing.cpp", "");
  const fs::path folder = scratch / "class";
  const Students expected{
      {"eve-lab1", "eve"}, {"max-labs", "max"}, {"s0101-lab3-lab3", "s0101"}, {"zoe", "zoe"}};
  EXPECT_EQ(students_in({folder}), expected);
  EXPECT_EQ(students_in({folder / "eve", folder / "max", folder / "s0101", folder / "zoe"}),
            expected)
      << "folders that are named one by one";
  EXPECT_EQ(students_in({folder / "eve/lab1.zip", folder / "zoe/lab3"}),
            (Students{{"eve-lab1", "eve"}, {"zoe-lab3", "zoe"}}));
}

TEST(Discovery, TheFoldersAroundASubmissionAreKnown) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/sectionA/s0101/lab3.zip", "");
  files::write_file(scratch / "class/sectionA/s0102/labs/lab3_hill_climbing/a.cpp", "");
  files::write_file(scratch / "class/sectionB/lab3/lab3.zip", "");
  files::write_file(scratch / "class/s0103.zip", "");
  std::map<std::string, std::vector<std::string>> folders;
  for (const FoundSubmission& found :
       find_submissions({scratch / "class"}, project_catalogue()).submissions) {
    folders[found.name] = found.folders;
  }
  const std::map<std::string, std::vector<std::string>> expected{
      {"sectionA-s0101-lab3", {"sectionA", "s0101"}},
      {"sectionA-s0102", {"sectionA"}},
      {"sectionB-lab3-lab3", {"sectionB"}},
      {"s0103", {}}};
  EXPECT_EQ(folders, expected);
}

TEST(Discovery, LinksAmongSubmissionsAreListed) {
  const ScratchFolder scratch;
  files::write_file(scratch / "elsewhere/bob.zip", "");
  files::write_file(scratch / "class/ada.zip", "");
  fs::create_symlink(scratch / "elsewhere/bob.zip", scratch / "class/bob.zip");
  fs::create_directory_symlink(scratch / "elsewhere", scratch / "class/eve");
  const Discovery found = find_submissions({scratch / "class"}, project_catalogue());
  EXPECT_EQ(found.submissions.size(), 1U);
  ASSERT_EQ(found.skipped.size(), 2U);
  EXPECT_NE(found.skipped[0].path.find("class/bob.zip"), std::string::npos);
  EXPECT_NE(found.skipped[1].reason.find("symbolic link"), std::string::npos);
}

TEST(Discovery, WhatCannotBeReadGetsARecord) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/ada/lab3.rar", "Rar!");
  files::write_file(scratch / "class/bob/report.pdf", "");
  files::write_file(scratch / "class/EVE.ZIP", "");
  const Discovery found = find_submissions({scratch / "class"}, project_catalogue());
  ASSERT_EQ(found.submissions.size(), 3U);
  EXPECT_EQ(found.submissions[0].student, "EVE");
  EXPECT_EQ(found.submissions[1].student, "ada");
  EXPECT_EQ(found.submissions[2].student, "bob");
  for (const FoundSubmission& submission : found.submissions) {
    EXPECT_NE(read_submission(submission, project_catalogue()).trouble, "") << submission.name;
  }
}

TEST(Discovery, OnlyAnArchiveHasATimeOfSubmission) {
  const ScratchFolder scratch;
  files::write_file(scratch / "class/ada.zip", "");
  files::write_file(scratch / "class/bob/labs/lab3_hill_climbing/a.cpp", "");
  const Discovery found = find_submissions({scratch / "class/"}, project_catalogue());
  ASSERT_EQ(found.submissions.size(), 2U);
  EXPECT_TRUE(found.submissions[0].time);
  EXPECT_FALSE(found.submissions[1].time) << "that of a folder is when it was cloned or unpacked";
  EXPECT_FALSE(read(scratch / "class/bob").file_time);
}

TEST(Discovery, NamesOfRecordsAreSafe) {
  EXPECT_EQ(safe_name("ada"), "ada");
  EXPECT_EQ(safe_name("../a b"), "_.._a_b");
  EXPECT_EQ(safe_name("-rf"), "_-rf");
  EXPECT_EQ(safe_name(""), "_");
}

}  // namespace
}  // namespace cs550::gradebook
