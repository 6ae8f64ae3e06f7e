#pragma once
/// @file require.hpp
/// Ends a test at a failed expectation that the rest of the test depends on.

#include <gtest/gtest.h>

namespace cs550::test {

/// Ends the running test if an expectation failed: `require(story.expect_near(…))`. The failure has
/// been reported. Its consequences are not.
/// @throws testing::AssertionException, which GoogleTest treats as already reported
inline void require(bool held) {
  if (held) return;
  throw testing::AssertionException(testing::TestPartResult(testing::TestPartResult::kFatalFailure,
                                                            nullptr, -1, "the test ends here"));
}

}  // namespace cs550::test
