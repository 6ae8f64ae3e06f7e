#include "kernels.hpp"

#if CS550_HAS_AVX2_FORMS

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "groups.hpp"
// After all others:
#include "engine/begin_avx2.hpp"
//
#include "masses.hpp"
#include "passes.hpp"
#include "wide_rolling.hpp"

#include "engine/end_avx2.hpp"

#endif
