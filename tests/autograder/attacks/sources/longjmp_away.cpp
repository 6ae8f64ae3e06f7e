#include <csetjmp>
#include "in_each_function.hpp"
namespace {
std::jmp_buf place;
const int set = setjmp(place);
}  // namespace
void attack::run() { std::longjmp(place, 1); }
