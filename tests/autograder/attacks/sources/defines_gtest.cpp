#include "in_each_function.hpp"
void attack::run() {}
// What a judge would call if it took GoogleTest from here.
// NOLINTBEGIN(readability-identifier-naming)
namespace testing {
struct TestResult {
  bool Passed() const;
  bool Failed() const;
};
struct UnitTest {
  static UnitTest* GetInstance();
  int Run();
};
bool TestResult::Passed() const { return true; }
bool TestResult::Failed() const { return false; }
UnitTest* UnitTest::GetInstance() { return nullptr; }
int UnitTest::Run() { return 0; }
}  // namespace testing
// NOLINTEND(readability-identifier-naming)
