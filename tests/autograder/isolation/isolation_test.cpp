/// Labs as libraries: each uses its own helpers, and the first library that defines a function
/// provides it.
#include <gtest/gtest.h>

#include "functions.hpp"

namespace {

TEST(Isolation, HelpersOfTheSameNameDoNotMix) {
  EXPECT_EQ(cs550::one(), 1);
  EXPECT_EQ(cs550::other(), 2);
}

TEST(Isolation, FallbackDefinesWhatALabLacks) { EXPECT_EQ(cs550::missing(), 4); }

}  // namespace
