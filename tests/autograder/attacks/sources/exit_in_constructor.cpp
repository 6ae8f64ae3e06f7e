#include <cstdlib>
namespace {
const bool left = (std::exit(0), true);
}
