// Where the project and an installed engine must not be.
#include "autograder/grader/place.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <string>

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

/// A folder like /usr, in which a file may be installed.
class System {
 public:
  System() {
    std::string name = (std::filesystem::temp_directory_path() / "place-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~System() { std::filesystem::remove_all(folder_); }
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// The engine that is found once the only file is this one.
  std::string engine_in(const std::string& file) const {
    const std::filesystem::path installed = folder_ / file;
    std::filesystem::create_directories(installed.parent_path());
    std::ofstream(installed) << "a library";
    const std::filesystem::path found = installed_engine(folder_);
    std::filesystem::remove(installed);
    return found.empty() ? "" : found.lexically_relative(folder_).string();
  }

 private:
  std::filesystem::path folder_;
};

TEST(Place, AnInstalledEngineIsFound) {
  const System usr;
  for (const char* file :
       {"lib/libcs550.so", "local/lib/libcs550.so.1.0", "lib/x86_64-linux-gnu/liblab3_reference.so",
        "local/lib64/liblab7_fast.so", "local/course/lib/libcs550.so", "liblab12_reference.so"}) {
    EXPECT_EQ(usr.engine_in(file), file);
  }
  for (const char* file : {"lib/liblab.so.1", "lib/libcs5500.so", "lib/liblab3_stub.so",
                           "share/doc/libcs550.so.txt", "lib/liblabels_fast.so"}) {
    EXPECT_EQ(usr.engine_in(file), "") << file;
  }
}

}  // namespace
}  // namespace cs550::grader
