// Where the project and an installed engine must not be.
#include "autograder/grader/place.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "helpers/scratch_folder.hpp"

namespace cs550::grader {
namespace {

TEST(Place, SubmissionsSeeTheFoldersOfTheSystem) {
  EXPECT_TRUE(is_seen_by_submissions("/usr/local/src/cs550/tests"));
  EXPECT_TRUE(is_seen_by_submissions("/usr"));
  EXPECT_TRUE(is_seen_by_submissions("/lib/cs550"));
  EXPECT_FALSE(is_seen_by_submissions("/usr2/cs550"));
  EXPECT_FALSE(is_seen_by_submissions("/home/usr/cs550"));
  EXPECT_FALSE(is_seen_by_submissions("/"));
}

/// The engine that is found in a folder like /usr if this is its only file.
std::string engine_in_folder_with(const std::string& file) {
  const test::ScratchFolder usr;
  std::filesystem::create_directories((usr / file).parent_path());
  std::ofstream(usr / file) << "a library";
  const std::filesystem::path found = installed_engine(usr.path());
  return found.empty() ? "" : found.lexically_relative(usr.path()).string();
}

TEST(Place, AnInstalledEngineIsFound) {
  for (const char* file :
       {"lib/libcs550.so", "local/lib/libcs550.so.1.0", "lib/x86_64-linux-gnu/liblab3_reference.so",
        "local/lib64/liblab7_fast.so", "local/course/lib/libcs550.so", "liblab12_reference.so"}) {
    EXPECT_EQ(engine_in_folder_with(file), file);
  }
  for (const char* file : {"lib/liblab.so.1", "lib/libcs5500.so", "lib/liblab3_stub.so",
                           "share/doc/libcs550.so.txt", "lib/liblabels_fast.so"}) {
    EXPECT_EQ(engine_in_folder_with(file), "") << file;
  }
}

}  // namespace
}  // namespace cs550::grader
