#include "in_each_function.hpp"
namespace {
struct Thrower {
  ~Thrower() { throw 7; }
};
}  // namespace
void attack::run() { const Thrower thrower; }
