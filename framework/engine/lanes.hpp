#pragma once
/// @file lanes.hpp
/// Arithmetic on eight constraints or bodies at a time. A *wide* number holds eight, one for each of
/// them, in the lanes of vector registers; a lane is one element of it. All operations act lane by lane
/// and round as scalar ones do.
///
/// SSE and NEON registers hold four floats: a wide number is two of them. That pays too, since a contact
/// is one long chain of operations that wait for each other, and two registers are two such chains.
/// AVX2 registers hold all eight (see begin_avx2.hpp). Both forms have the same layout in memory.
///
/// Why not Eigen::Array<Real, 8, 1>: its select() is not vectorised, and its sqrt() rounds
/// differently.

#include <cmath>
#include <cstdint>
#include <cstring>

#include "cs550/math.hpp"
#include "engine/lane_count.hpp"

#ifndef CS550_LANES
#define CS550_LANES lanes_of_four
#define CS550_LANES_IN_A_REGISTER 4
#endif

namespace cs550::CS550_LANES {

inline constexpr std::size_t part_size = CS550_LANES_IN_A_REGISTER;
inline constexpr std::size_t part_count = lane_count / part_size;

/// One register: a vector type of g++ and clang++.
using Part __attribute__((vector_size(part_size * sizeof(Real)))) = Real;
using PartMask = decltype(Part{} < Part{});

struct WideReal {
  Part part[part_count];

  Real operator[](std::size_t lane) const { return part[lane / part_size][lane % part_size]; }
  void set(std::size_t lane, Real x) { part[lane / part_size][lane % part_size] = x; }
};

/// All bits of a lane are set, or none.
struct WideMask {
  PartMask part[part_count];

  bool operator[](std::size_t lane) const { return part[lane / part_size][lane % part_size] != 0; }
};

/// Applies `operation` to the registers.
/// @{
template <class Operation>
WideReal by_part(const Operation& operation) {
  WideReal result;
  for (std::size_t i = 0; i < part_count; ++i) result.part[i] = operation(i);
  return result;
}
template <class Operation>
WideMask mask_by_part(const Operation& operation) {
  WideMask result;
  for (std::size_t i = 0; i < part_count; ++i) result.part[i] = operation(i);
  return result;
}
/// @}

inline WideReal operator+(WideReal x, WideReal y) {
  return by_part([&](std::size_t i) { return x.part[i] + y.part[i]; });
}
inline WideReal operator-(WideReal x, WideReal y) {
  return by_part([&](std::size_t i) { return x.part[i] - y.part[i]; });
}
inline WideReal operator*(WideReal x, WideReal y) {
  return by_part([&](std::size_t i) { return x.part[i] * y.part[i]; });
}
inline WideReal operator/(WideReal x, WideReal y) {
  return by_part([&](std::size_t i) { return x.part[i] / y.part[i]; });
}
inline WideReal operator-(WideReal x) {
  return by_part([&](std::size_t i) { return -x.part[i]; });
}
inline WideMask operator<(WideReal x, WideReal y) {
  return mask_by_part([&](std::size_t i) { return x.part[i] < y.part[i]; });
}
inline WideMask operator>(WideReal x, WideReal y) { return y < x; }
inline WideMask operator<=(WideReal x, WideReal y) {
  return mask_by_part([&](std::size_t i) { return x.part[i] <= y.part[i]; });
}
inline WideMask operator==(WideReal x, WideReal y) {
  return mask_by_part([&](std::size_t i) { return x.part[i] == y.part[i]; });
}
inline WideMask operator&(WideMask x, WideMask y) {
  return mask_by_part([&](std::size_t i) { return x.part[i] & y.part[i]; });
}
inline WideMask operator|(WideMask x, WideMask y) {
  return mask_by_part([&](std::size_t i) { return x.part[i] | y.part[i]; });
}
inline WideMask operator~(WideMask x) {
  return mask_by_part([&](std::size_t i) { return ~x.part[i]; });
}

/// The same number in every lane.
inline WideReal all_lanes(Real x) {
  return by_part([&](std::size_t) { return x - Part{}; });
}

/// x where the mask is set, otherwise y.
inline WideReal select(WideMask mask, WideReal x, WideReal y) {
  return by_part([&](std::size_t i) { return mask.part[i] ? x.part[i] : y.part[i]; });
}

inline bool any(WideMask mask) {
  std::uint64_t words[sizeof mask / sizeof(std::uint64_t)];
  std::memcpy(words, &mask, sizeof mask);
  return (words[0] | words[1] | words[2] | words[3]) != 0;
}
inline bool all(WideMask mask) { return !any(~mask); }

/// std::max(x, y) and std::min(x, y).
inline WideReal larger(WideReal x, WideReal y) { return select(x < y, y, x); }
inline WideReal smaller(WideReal x, WideReal y) { return select(y < x, y, x); }

inline WideReal square_root(WideReal x) {
  return by_part([&](std::size_t i) {
    Part root = x.part[i];
    for (std::size_t lane = 0; lane < part_size; ++lane) root[lane] = std::sqrt(root[lane]);
    return root;
  });
}

}  // namespace cs550::CS550_LANES
