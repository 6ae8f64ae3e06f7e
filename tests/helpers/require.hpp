#pragma once
/// @file require.hpp
/// Ends a test at an expectation without which the rest of it means nothing.

#include <gtest/gtest.h>

namespace cs550::test {

/// Ends the running test if an expectation did not hold: `require(story.expect_near(…))`. What was
/// expected has been reported by then; what would follow from it is not.
/// @throws testing::AssertionException which GoogleTest takes as "already reported"
inline void require(bool held) {
  if (held) return;
  throw testing::AssertionException(testing::TestPartResult(testing::TestPartResult::kFatalFailure,
                                                            nullptr, -1, "the test ends here"));
}

}  // namespace cs550::test
