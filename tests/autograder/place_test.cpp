// Where the project must not be.
#include "autograder/grader/place.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cs550::grader
