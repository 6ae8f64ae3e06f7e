#include "kernels.hpp"
#include "masses.hpp"
#include "passes.hpp"
#include "wide_rolling.hpp"
