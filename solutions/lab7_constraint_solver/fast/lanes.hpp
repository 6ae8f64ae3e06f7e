#pragma once
/// @file lanes.hpp
/// Arithmetic on four constraints at a time. A *wide* number holds four, one for each constraint,
/// in the lanes of a vector register; a lane is one element of it. All operations act lane by lane,
/// round as scalar ones do and keep the order in which Eigen evaluates them, so that each lane
/// holds the bits of the teaching form.
///
/// Why not Eigen::Array<Real, 4, 1>: a pass takes 1.3 times as long with it, since its select() is
/// not vectorised, and its sqrt() rounds differently.

#include <cmath>

#include "cs550/math.hpp"

namespace cs550 {

inline constexpr std::size_t lane_count = 4;

/// A vector type of g++ and clang++; SSE and NEON registers hold four floats. Arithmetic and
/// comparisons act on all lanes, `mask ? x : y` selects in each lane.
using WideReal __attribute__((vector_size(lane_count * sizeof(Real)))) = Real;
using WideMask = decltype(WideReal{} < WideReal{});

/// The same number in every lane.
inline WideReal all_lanes(Real x) { return WideReal{x, x, x, x}; }

inline bool any(WideMask mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// std::max(x, y) and std::min(x, y).
inline WideReal larger(WideReal x, WideReal y) { return x < y ? y : x; }
inline WideReal smaller(WideReal x, WideReal y) { return y < x ? y : x; }

inline WideReal square_root(WideReal x) {
  return WideReal{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

/// Rows to columns: w0 gets the first numbers of w0 to w3, w1 the second ones, and so on.
inline void transpose(WideReal& w0, WideReal& w1, WideReal& w2, WideReal& w3) {
  const WideReal low01 = __builtin_shufflevector(w0, w1, 0, 4, 1, 5);
  const WideReal low23 = __builtin_shufflevector(w2, w3, 0, 4, 1, 5);
  const WideReal high01 = __builtin_shufflevector(w0, w1, 2, 6, 3, 7);
  const WideReal high23 = __builtin_shufflevector(w2, w3, 2, 6, 3, 7);
  w0 = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  w1 = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  w2 = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  w3 = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

struct WideVec3 {
  WideReal x, y, z;

  WideReal dot(const WideVec3& o) const { return x * o.x + (y * o.y + z * o.z); }
  WideVec3 cross(const WideVec3& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
};

inline WideVec3 operator+(const WideVec3& a, const WideVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline WideVec3 operator-(const WideVec3& a, const WideVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline WideVec3 operator-(const WideVec3& a) { return {-a.x, -a.y, -a.z}; }
inline WideVec3 operator*(WideReal s, const WideVec3& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Elements in the order in which Eigen stores them, column by column.
struct WideMat2 {
  WideReal uu, vu, uv, vv;
};

struct WideMat3 {
  WideVec3 column[3];

  WideVec3 operator*(const WideVec3& a) const {
    const auto& [c0, c1, c2] = column;
    return {c0.x * a.x + (c1.x * a.y + c2.x * a.z), c0.y * a.x + (c1.y * a.y + c2.y * a.z),
            c0.z * a.x + (c1.z * a.y + c2.z * a.z)};
  }
};

}  // namespace cs550
