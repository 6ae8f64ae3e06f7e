#include "sweeps.hpp"
#include "sweeps_in_lanes.hpp"
