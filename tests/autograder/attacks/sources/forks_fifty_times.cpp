#include <unistd.h>
namespace {
int leave_children() {
  for (int i = 0; i < 50; ++i) {
    if (fork() == 0) {
      setsid();
      while (true) sleep(1000);
    }
  }
  return 0;
}
const int left = leave_children();
}  // namespace
