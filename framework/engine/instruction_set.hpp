#pragma once
/// @file instruction_set.hpp
/// Which vector instructions this processor has. Results do not depend on it.

namespace cs550 {

/// Source files for processors with AVX2 are compiled where that is possible.
#if defined(__x86_64__) && defined(__GNUC__)
#define CS550_HAS_AVX2_FORMS 1
inline bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
#else
#define CS550_HAS_AVX2_FORMS 0
#endif

}  // namespace cs550
