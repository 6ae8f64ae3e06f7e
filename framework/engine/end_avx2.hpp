/// @file end_avx2.hpp
/// See begin_avx2.hpp.

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
