#include "sweeps_in_lanes.hpp"

#if CS550_HAS_AVX2_FORMS

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

// After all others:
#include "engine/begin_avx2.hpp"
//
#include "sweeps.hpp"

#include "engine/end_avx2.hpp"

#endif
