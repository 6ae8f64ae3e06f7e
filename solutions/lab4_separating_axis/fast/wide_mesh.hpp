#pragma once
/// @file wide_mesh.hpp
/// Vertices and planes of a mesh, four at a time, and a search for the largest of many numbers. Every
/// polyhedron has at least four vertices and four faces.

#include <algorithm>
#include <cstring>

#include "cs550/half_edge_mesh.hpp"
#include "engine/lanes.hpp"

namespace cs550 {

/// Calls visit(i) such that i to i + 3 cover all numbers below `count`. The last four may overlap
/// those before. @pre count ≥ 4
template <class Visit>
void for_all_fours(Index count, const Visit& visit) {
  constexpr auto four = static_cast<Index>(lane_count);
  for (Index i = 0; i + four <= count; i += four) visit(i);
  if (count % four != 0) visit(count - four);
}

inline WideReal four_reals(const Real* first) {
  WideReal reals;
  std::memcpy(&reals, first, sizeof reals);
  return reals;
}

/// Vertices v to v + 3.
inline WideVec3 four_vertices(const HalfEdgeMesh& mesh, Index v) {
  static_assert(sizeof(Vec3) == 3 * sizeof(Real));
  const Real* const first = mesh.vertices[v].data();
  const WideReal a = four_reals(first);      // x0 y0 z0 x1
  const WideReal b = four_reals(first + 4);  // y1 z1 x2 y2
  const WideReal c = four_reals(first + 8);  // z2 x3 y3 z3
  const WideReal x012 = __builtin_shufflevector(a, b, 0, 3, 6, 6);
  const WideReal y012 = __builtin_shufflevector(a, b, 1, 4, 7, 7);
  const WideReal z01 = __builtin_shufflevector(a, b, 2, 5, 5, 5);
  return {__builtin_shufflevector(x012, c, 0, 1, 2, 5),
          __builtin_shufflevector(y012, c, 0, 1, 2, 6),
          __builtin_shufflevector(z01, c, 0, 1, 4, 7)};
}

/// Plane::distance() of a point from the planes of faces f to f + 3. Past the last face, that is repeated.
inline WideReal four_distances(const HalfEdgeMesh& mesh, Index f, const WideVec3& point) {
  static_assert(sizeof(Plane) == 4 * sizeof(Real));
  const Index last = mesh.face_count() - 1;
  const auto plane = [&](Index face) {
    return four_reals(mesh.face(std::min(face, last)).plane.normal.data());
  };
  WideReal x = plane(f);
  WideReal y = plane(f + 1);
  WideReal z = plane(f + 2);
  WideReal offset = plane(f + 3);
  transpose(x, y, z, offset);
  return WideVec3{x, y, z}.dot(point) - offset;
}

/// The largest of numbers that are offered four at a time.
class WideSearch {
 public:
  /// @param first the number of the first of the four
  void offer(WideReal four, Index first) {
    const WideMask more = four > largest_;
    largest_ = more ? four : largest_;
    where_ = more ? WideMask{first, first + 1, first + 2, first + 3} : where_;
  }

  /// The smallest number of those with the largest value.
  Index first_largest() const {
    std::size_t best = 0;
    for (std::size_t lane = 1; lane < lane_count; ++lane) {
      const bool equal = largest_[lane] == largest_[best];
      if (largest_[lane] > largest_[best] || (equal && where_[lane] < where_[best])) best = lane;
    }
    return where_[best];
  }

 private:
  WideReal largest_ = all_lanes(-HUGE_VALF);
  WideMask where_ = {};
};

}  // namespace cs550
