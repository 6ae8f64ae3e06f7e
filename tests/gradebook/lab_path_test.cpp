/// To which lab a file belongs, by its path in a submission.
#include "gradebook/intake/lab_path.hpp"

#include <gtest/gtest.h>

#include "gradebook_test.hpp"

namespace cs550::gradebook {
namespace {

LabPath place(const std::string& path) { return lab_path(path, project_catalogue()); }

TEST(LabPath, FilesBelowALabsFolderAreTaken) {
  EXPECT_EQ(place("labs/lab3_hill_climbing/hill_climbing.cpp").lab, 3);
  EXPECT_EQ(place("ada-main/labs/lab3_hill_climbing/util/cache.hpp").file, "util/cache.hpp");
  EXPECT_EQ(place("lab3_hill_climbing/a.h").lab, 3);
  EXPECT_EQ(place("Lab3/a.cpp").lab, 3);
  EXPECT_EQ(place("./labs//lab3_hill_climbing/./a.cpp").file, "a.cpp");
  EXPECT_EQ(place("labs\\lab3_hill_climbing\\a.cpp").lab, 3) << "a zip made by Windows";
}

/// "3 util/a.hpp": the lab of a path, and the file in its folder.
std::string place_text(const std::string& path) {
  const LabPath found = place(path);
  return std::to_string(found.lab) + ' ' + found.file;
}

TEST(LabPath, FoldersAroundThatOfTheLabMayNameAnyLab) {
  for (const char* around :
       {"lab3/labs/", "lab7/labs/", "lab3_hill_climbing/labs/", "lab3/ada-main/labs/", "lab3/",
        "Lab3/", "lab4/", "lab3_hill_climbing/", "lab7/code/", "lab3/lab3/"}) {
    EXPECT_EQ(place_text(around + std::string("lab3_hill_climbing/util/a.hpp")), "3 util/a.hpp")
        << around;
  }
  EXPECT_EQ(place_text("lab3/lab3/a.cpp"), "3 a.cpp");
  EXPECT_EQ(place_text("lab7/lab3/a.cpp"), "3 a.cpp");
  const LabPath unpacked = place("s0101/lab7/labs/lab1_integration/integration.cpp");
  EXPECT_EQ(unpacked.lab, 1);
  EXPECT_TRUE(unpacked.is_in_project);
  EXPECT_EQ(unpacked.project, "s0101/lab7");
}

TEST(LabPath, AFolderInThatOfTheLabMayHaveTheNameOfALab) {
  EXPECT_EQ(place_text("labs/lab3_hill_climbing/lab3/a.hpp"), "3 lab3/a.hpp");
  EXPECT_EQ(place_text("labs/lab3_hill_climbing/lab3_hill_climbing/a.hpp"),
            "3 lab3_hill_climbing/a.hpp");
  EXPECT_EQ(place_text("labs/lab3_hill_climbing/labs/lab1_integration/a.hpp"),
            "3 labs/lab1_integration/a.hpp");
  EXPECT_EQ(place_text("lab3_hill_climbing/lab4/a.hpp"), "3 lab4/a.hpp");
  EXPECT_EQ(place_text("lab3_hill_climbing/old/lab3_hill_climbing/a.cpp"),
            "3 old/lab3_hill_climbing/a.cpp");
  EXPECT_EQ(place_text("lab3/old/lab3/a.cpp"), "3 old/lab3/a.cpp");
  EXPECT_EQ(place_text("lab3/tests/lab3_hill_climbing/a.hpp"), "3 tests/lab3_hill_climbing/a.hpp");
}

TEST(LabPath, AFileWithTheNameOfAStarterIsTakenAnywhere) {
  EXPECT_EQ(place("hill_climbing.cpp").lab, 3);
  EXPECT_EQ(place("homework/merging.cpp").lab, 2);
}

TEST(LabPath, OtherFilesAreIgnoredWithTheReason) {
  for (const char* path : {"tests/lab3_hill_climbing/a.cpp", "solutions/lab3_hill_climbing/a.cpp",
                           ".starters/lab3_hill_climbing/hill_climbing.cpp", "framework/a.cpp",
                           "CMakeLists.txt", "build/hill_climbing.cpp", "notes.cpp"}) {
    EXPECT_EQ(place(path).lab, 0) << path;
    EXPECT_EQ(place(path).ignored, outside_of_labs) << path;
  }
  EXPECT_NE(place("labs/lab3_hill_climbing/README.md").ignored.find("C++"), std::string::npos);
  EXPECT_NE(place("labs/lab3_hill_climbing/a.cpp.bak-1").ignored.find("C++"), std::string::npos);
  EXPECT_EQ(place("labs/lab3_hill_climbing/a.tpp").lab, 3);
  EXPECT_NE(place("labs/lab3_hill_climbing/my util.h").ignored.find("letters"), std::string::npos);
  EXPECT_EQ(place("Ada's work/labs/lab3_hill_climbing/util.h").lab, 3)
      << "only names in the lab count";
  EXPECT_EQ(place("labs/lab3_hill_climbing/._a.cpp").ignored, "hidden file");
}

TEST(LabPath, UnsafeNamesAreRefused) {
  EXPECT_EQ(place("/labs/lab3_hill_climbing/a.cpp").ignored, "absolute path");
  EXPECT_EQ(place("C:\\labs\\lab3_hill_climbing\\a.cpp").ignored, "absolute path");
  EXPECT_EQ(place("labs/lab3_hill_climbing/../../a.cpp").ignored, "path with ..");
  EXPECT_EQ(place("labs/lab3_hill_climbing\\..\\a.cpp").ignored, "path with ..");
  EXPECT_NE(place("labs/lab3_hill_climbing/\033[2Ja.cpp").ignored, "");
  EXPECT_NE(place("labs/lab3_hill_climbing/\xFF.cpp").ignored, "");
  EXPECT_NE(place("labs/lab3_hill_climbing/" + std::string(300, 'a') + ".cpp").ignored, "");
  EXPECT_NE(place("").ignored, "");
  EXPECT_EQ(place("/\x9A/labs/lab3_hill_climbing/a.cpp").ignored, "absolute path");
  EXPECT_EQ(place("\x9A/../labs/lab3_hill_climbing/a.cpp").ignored, "path with ..");
  EXPECT_NE(place(std::string(10'000, 'a') + "/lab3/a.cpp").ignored, "");
}

TEST(LabPath, AnyFoldersMayBeAroundThatOfTheLab) {
  for (const std::string& folder :
       {std::string("\232bung 3"), std::string("\033[2J"), std::string(300, 'a')}) {
    EXPECT_EQ(place_text(folder + "/labs/lab3_hill_climbing/a.cpp"), "3 a.cpp") << folder;
    EXPECT_EQ(place_text(folder + "/lab3/a.cpp"), "3 a.cpp") << folder;
    EXPECT_EQ(place_text(folder + "/hill_climbing.cpp"), "3 hill_climbing.cpp") << folder;
  }
}

}  // namespace
}  // namespace cs550::gradebook
