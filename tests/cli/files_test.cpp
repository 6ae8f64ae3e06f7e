/// Files that the command line reads.
#include "cli/system/files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "helpers/scratch_folder.hpp"

namespace {

using cs550::cli::fingerprint_of;

/// While an editor saves, a file may vanish between listing and reading.
TEST(Files, OneThatIsGoneHasNoPartInAFingerprint) {
  const cs550::test::ScratchFolder folder;
  std::ofstream(folder / "topic.cpp") << "int mine;";
  EXPECT_EQ(fingerprint_of({folder / "4913", folder / "topic.cpp"}),
            fingerprint_of({folder / "topic.cpp"}));
}

}  // namespace
