#include "kernels.hpp"
#include "masses.hpp"
#include "passes.hpp"
