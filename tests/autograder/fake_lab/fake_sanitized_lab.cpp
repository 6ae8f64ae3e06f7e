/// Graded tests for graded_run_test.cpp: a memory error that does not crash by itself, and a loop without end.
#include <cs550/graded_test.hpp>
#include <vector>

GRADED_TEST(Lab5, ReadsPastTheEnd, 1, "L5.1") {
  const std::vector<int> three(3);
  volatile std::size_t fourth = 3;  // volatile hides the value from the compiler
  EXPECT_NE(three.data()[fourth], 550);
}

GRADED_TEST(Lab5, NeverEnds, 1, "L5.2") {
  volatile bool again = true;
  while (again) {
  }
}
