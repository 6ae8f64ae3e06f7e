/// A graded test with a memory error that does not crash by itself, for graded_run_test.cpp.
#include <cs550/graded_test.hpp>
#include <vector>

GRADED_TEST(Lab5, ReadsPastTheEnd, 1, "L5.1") {
  const std::vector<int> three(3);
  volatile std::size_t fourth = 3;  // volatile hides the value from the compiler
  EXPECT_NE(three.data()[fourth], 550);
}
