#include <stdexcept>
#include "in_each_function.hpp"
void attack::run() {
  throw std::runtime_error(
      "\x1b[2J\x1b[32mPASSED\x1b[0m \x07 <script>alert(1)</script> \",\"earned\":60} "
      "\xff\xfe\u202e");
}
