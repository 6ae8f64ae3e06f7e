#include <cstdio>
namespace {
int print() {
  for (int i = 0; i < 200000; ++i) std::printf("%080d\n", i);
  return 0;
}
const int printed = print();
}  // namespace
