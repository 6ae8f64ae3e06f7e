// Files that are written as a whole or not at all.
#include "files/output_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/system/draft_folder.hpp"
#include "cli/system/files.hpp"
#include "files/path_argument.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550::files {
namespace {

namespace fs = std::filesystem;

class Output : public testing::Test {
 protected:
  fs::path file(const std::string& name) const { return folder_ / name; }
  std::string content(const std::string& name) const { return cli::read_text(file(name)); }
  std::ptrdiff_t count() const {
    return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  }

 private:
  test::ScratchFolder folder_;
};

const fs::path shared_memory = "/dev/shm";

/// In a container, two processes may have the same number.
TEST_F(Output, ADraftOfAnEarlierProcessIsNoObstacle) {
  std::ofstream(file("table.csv.draft" + std::to_string(getpid()))) << "half";
  write_file(file("table.csv"), "whole");
  EXPECT_EQ(content("table.csv"), "whole");
  EXPECT_EQ(count(), 1);
}

TEST_F(Output, BehindALinkIsReplacedAsAWhole) {
  std::ofstream(file("target")) << "before";
  fs::create_directory(file("folder"));
  fs::create_symlink("folder/second", file("first"));
  fs::create_symlink("../target", file("folder/second"));
  {
    OutputFile output(file("first"));
    output.write("half");
    EXPECT_EQ(content("target"), "before") << "until it is complete";
  }
  EXPECT_EQ(content("target"), "before") << "it was never completed";
  write_file(file("first"), "after");
  EXPECT_EQ(content("target"), "after");
  EXPECT_TRUE(fs::is_symlink(file("first")));
  EXPECT_TRUE(fs::is_symlink(file("folder/second")));
  EXPECT_EQ(count(), 3);
}

TEST_F(Output, BehindALinkToSharedMemoryIsReplacedAsAWhole) {
  if (!fs::is_directory(shared_memory)) GTEST_SKIP() << "there is no /dev/shm";
  const test::ScratchFolder folder(shared_memory);
  const fs::path target = folder / "target";
  std::ofstream(target) << "before";
  fs::create_symlink(target, file("link"));
  {
    OutputFile output(file("link"));
    output.write("half");
    EXPECT_EQ(cli::read_text(target), "before") << "until it is complete";
  }
  write_file(file("link"), "after");
  EXPECT_EQ(cli::read_text(target), "after");
  EXPECT_TRUE(fs::is_symlink(file("link")));
}

TEST_F(Output, MustHaveItsEndingInSharedMemoryToo) {
  if (!fs::is_directory(shared_memory)) GTEST_SKIP() << "there is no /dev/shm";
  const test::ScratchFolder folder(shared_memory);
  const std::string code = folder / "code.cpp";
  std::ofstream(code) << "int code;";
  EXPECT_EQ(fault_of_ending(code, ".zip"), "'" + code + "' must end in .zip");
  const std::string link = folder / "link";
  fs::create_symlink(code, link);
  EXPECT_EQ(fault_of_ending(link, ".zip"), "'" + link + "' must end in .zip");
  EXPECT_EQ(fault_of_ending("/dev/null", ".zip"), "");
}

TEST_F(Output, BehindALinkToNothingIsMade) {
  fs::create_symlink("target", file("link"));
  write_file(file("link"), "new");
  EXPECT_TRUE(fs::is_symlink(file("link")));
  EXPECT_EQ(content("target"), "new");
}

TEST_F(Output, BehindALinkToNothingIsMadeAsAWhole) {
  fs::create_symlink("second", file("first"));
  fs::create_symlink(file("target"), file("second"));
  {
    OutputFile output(file("first"));
    output.write("half");
  }
  EXPECT_FALSE(fs::exists(file("target")));
  EXPECT_EQ(count(), 2);
}

TEST_F(Output, BehindLinksInACircleIsRefused) {
  fs::create_symlink("second", file("first"));
  fs::create_symlink("first", file("second"));
  EXPECT_THROW(write_file(file("first"), "new"), std::runtime_error);
}

TEST_F(Output, MayHaveTheLongestNameOfTheSystem) {
  const std::string name(255, 'a');
  write_file(file(name), "whole");
  EXPECT_EQ(content(name), "whole");
}

TEST_F(Output, KeepsThePermissionsOfTheFileThatItReplaces) {
  write_file(file("private"), "before");
  fs::permissions(file("private"), fs::perms::owner_read | fs::perms::owner_write);
  write_file(file("private"), "after");
  EXPECT_EQ(content("private"), "after");
  EXPECT_EQ(fs::status(file("private")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Output, OfTwoDraftsOfAFolderNoneIsTheOther) {
  const cli::DraftFolder one(file("copy"));
  const cli::DraftFolder other(file("copy"));
  EXPECT_NE(one.path(), other.path());
  EXPECT_TRUE(fs::is_directory(one.path()));
  EXPECT_TRUE(fs::is_directory(other.path()));
}

/// What a killed process leaves.
void leave_draft(const fs::path& folder) {
  fs::create_directories(folder / cli::DraftFolder::content / "labs");
}

TEST_F(Output, OnlyAbandonedDraftsOfTheFolderAreRemoved) {
  const cli::DraftFolder in_use(file("copy"));
  leave_draft(file("copy.partial-1"));
  leave_draft(file("copy.partial-1-2"));
  fs::create_directory(file("copy.partial-2"));  // killed before it had a draft
  leave_draft(file("copycat.partial-1"));
  leave_draft(file("copy.partial-results"));
  std::ofstream(file("copy.partial-3")) << "a file";
  EXPECT_EQ(cli::remove_abandoned_drafts(file("copy")).size(), 3U);
  EXPECT_TRUE(fs::is_directory(in_use.path()));
  EXPECT_EQ(count(), 4) << "the draft in use, another folder's, and two that are no drafts";
  EXPECT_TRUE(cli::remove_abandoned_drafts(file("absent") / "copy").empty());
}

TEST_F(Output, AFolderThatOnlyHasTheNameOfADraftStays) {
  fs::create_directory(file("copy.partial-1"));
  leave_draft(file("copy.partial-2"));
  for (const char* folder : {"copy.partial-1", "copy.partial-2"}) {
    std::ofstream(file(folder) / "notes.txt") << "the user's";
  }
  EXPECT_TRUE(cli::remove_abandoned_drafts(file("copy")).empty());
  EXPECT_EQ(content("copy.partial-1/notes.txt"), "the user's");
  EXPECT_EQ(content("copy.partial-2/notes.txt"), "the user's");
}

}  // namespace
}  // namespace cs550::files
