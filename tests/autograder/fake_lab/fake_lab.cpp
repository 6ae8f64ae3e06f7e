/// Graded tests with every outcome, for graded_test_test.cpp. "Lab5" represents any lab.
#include <cs550/graded_test.hpp>
#include <cs550/not_implemented.hpp>
#include <cs550/test_report.hpp>
#include <cstdlib>
#include <new>
#include <stdexcept>

using cs550::NotImplemented;

GRADED_TEST(Lab5, Passes, 6, "L5.1") {}

GRADED_TEST(Lab5, Fails, 5, "L5.1") { EXPECT_EQ(1, 2); }

GRADED_TEST(Lab5, ReachesAnUnwrittenStep, 4, "L5.2") { throw NotImplemented("L5.2", "clip"); }

GRADED_TEST(Lab5, ReachesAnEarlierLab, 3, "L5.2") { throw NotImplemented("L2.3", "merge"); }

GRADED_TEST(Lab5, ReachesALaterStep, 1, "L5.2") { throw NotImplemented("L5.4", "reduce"); }

GRADED_TEST(Lab5, Throws, 2, "L5.3", Long) { throw std::out_of_range("index 9 of 4"); }

GRADED_TEST(Lab5, ThrowsANumber, 2, "L5.3") { throw 7; }

GRADED_TEST(Lab5, AllocatesTooMuch, 1, "L5.3") { throw std::bad_alloc(); }

GRADED_TEST(Lab5, Crashes, 1, "L5.3") {
  cs550::autograder::note_case({"A polygon is clipped", {"3 corners"}, {}, {"an empty polygon"}});
  std::abort();
}

GRADED_TEST(Lab5, Leaves, 1, "L5.3") { std::exit(3); }

GRADED_TEST(Lab5, PassesToo, 1, "L5.3", Long) {}
