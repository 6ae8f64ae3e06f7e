/// @file begin_avx2.hpp
/// From here to end_avx2.hpp functions are compiled for AVX2, and wide numbers fill one register.
///
/// Include all other headers before this one. An inline function of theirs, compiled for AVX2, could be
/// the copy that the linker keeps for the whole program, which would then crash on other processors.

#define CS550_LANES lanes_of_eight
#define CS550_LANES_IN_A_REGISTER 8
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
