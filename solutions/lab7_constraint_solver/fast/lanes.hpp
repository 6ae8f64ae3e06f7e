#pragma once
/// @file lanes.hpp
/// Four constraints at a time: every number is four numbers, one in the lane of each constraint. All operations act
/// lane by lane and round as the scalar ones do, in the order in which Eigen computes them, so that
/// a lane holds the bits that the teaching form would.

#include <cmath>

#include "cs550/math.hpp"

namespace cs550 {

inline constexpr std::size_t lane_count = 4;

/// A vector type of g++ and clang++; SSE and NEON registers hold four floats. Arithmetic and
/// comparisons act on all lanes, `mask ? x : y` chooses in each.
using Lanes __attribute__((vector_size(lane_count * sizeof(Real)))) = Real;
using LaneMask = decltype(Lanes{} < Lanes{});

/// The same number in every lane.
inline Lanes all_lanes(Real x) { return Lanes{x, x, x, x}; }

inline bool any(LaneMask mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// std::max(x, y) and std::min(x, y).
inline Lanes larger(Lanes x, Lanes y) { return x < y ? y : x; }
inline Lanes smaller(Lanes x, Lanes y) { return y < x ? y : x; }

inline Lanes square_root(Lanes x) {
  return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

/// Constraints to columns: the first numbers of w0…w3 come into w0, the second ones into w1, and so on.
inline void transpose(Lanes& w0, Lanes& w1, Lanes& w2, Lanes& w3) {
  const Lanes low01 = __builtin_shufflevector(w0, w1, 0, 4, 1, 5);
  const Lanes low23 = __builtin_shufflevector(w2, w3, 0, 4, 1, 5);
  const Lanes high01 = __builtin_shufflevector(w0, w1, 2, 6, 3, 7);
  const Lanes high23 = __builtin_shufflevector(w2, w3, 2, 6, 3, 7);
  w0 = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  w1 = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  w2 = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  w3 = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

struct Vec3Lanes {
  Lanes x, y, z;

  Lanes dot(const Vec3Lanes& o) const { return x * o.x + (y * o.y + z * o.z); }
  Vec3Lanes cross(const Vec3Lanes& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
};

inline Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3Lanes operator-(const Vec3Lanes& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3Lanes operator*(Lanes s, const Vec3Lanes& a) { return {s * a.x, s * a.y, s * a.z}; }

/// By columns, as Eigen stores them.
struct Mat3Lanes {
  Vec3Lanes column[3];

  Vec3Lanes operator*(const Vec3Lanes& a) const {
    const auto& [c0, c1, c2] = column;
    return {c0.x * a.x + (c1.x * a.y + c2.x * a.z), c0.y * a.x + (c1.y * a.y + c2.y * a.z),
            c0.z * a.x + (c1.z * a.y + c2.z * a.z)};
  }
};

}  // namespace cs550
