#pragma once
/// @file wide_mesh.hpp
/// Vertices and planes of a mesh, four at a time, and a search for the largest of many numbers. Every
/// polyhedron has at least four vertices and four faces.

#include <algorithm>
#include <cstring>

#include "cs550/half_edge_mesh.hpp"
#include "engine/lanes.hpp"

namespace cs550 {

/// Four numbers in one register.
using Four = lanes_of_four::Part;
using FourMask = lanes_of_four::PartMask;

/// The same number four times.
inline Four four_times(Real x) { return x - Four{}; }

struct FourVectors {
  Four x, y, z;

  Four dot(const FourVectors& o) const { return x * o.x + (y * o.y + z * o.z); }
};

inline FourVectors four_times(const Vec3& v) {
  return {four_times(v.x()), four_times(v.y()), four_times(v.z())};
}
inline FourVectors operator-(const FourVectors& v) { return {-v.x, -v.y, -v.z}; }

/// Rows to columns.
inline void transpose(Four& w0, Four& w1, Four& w2, Four& w3) {
  const Four low01 = __builtin_shufflevector(w0, w1, 0, 4, 1, 5);
  const Four low23 = __builtin_shufflevector(w2, w3, 0, 4, 1, 5);
  const Four high01 = __builtin_shufflevector(w0, w1, 2, 6, 3, 7);
  const Four high23 = __builtin_shufflevector(w2, w3, 2, 6, 3, 7);
  w0 = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  w1 = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  w2 = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  w3 = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

/// Calls visit(i) such that i to i + 3 cover all numbers below `count`. The last four may overlap
/// those before. @pre count ≥ 4
template <class Visit>
void for_all_fours(Index count, const Visit& visit) {
  constexpr Index four = 4;
  for (Index i = 0; i + four <= count; i += four) visit(i);
  if (count % four != 0) visit(count - four);
}

inline Four four_reals(const Real* first) {
  Four reals;
  std::memcpy(&reals, first, sizeof reals);
  return reals;
}

/// Vertices v to v + 3.
inline FourVectors four_vertices(const HalfEdgeMesh& mesh, Index v) {
  static_assert(sizeof(Vec3) == 3 * sizeof(Real));
  const Real* const first = mesh.vertices[v].data();
  const Four a = four_reals(first);      // x0 y0 z0 x1
  const Four b = four_reals(first + 4);  // y1 z1 x2 y2
  const Four c = four_reals(first + 8);  // z2 x3 y3 z3
  const Four x012 = __builtin_shufflevector(a, b, 0, 3, 6, 6);
  const Four y012 = __builtin_shufflevector(a, b, 1, 4, 7, 7);
  const Four z01 = __builtin_shufflevector(a, b, 2, 5, 5, 5);
  return {__builtin_shufflevector(x012, c, 0, 1, 2, 5),
          __builtin_shufflevector(y012, c, 0, 1, 2, 6),
          __builtin_shufflevector(z01, c, 0, 1, 4, 7)};
}

/// Plane::distance() of a point from the planes of faces f to f + 3. Past the last face, that is repeated.
inline Four four_distances(const HalfEdgeMesh& mesh, Index f, const FourVectors& point) {
  static_assert(sizeof(Plane) == 4 * sizeof(Real));
  const Index last = mesh.face_count() - 1;
  const auto plane = [&](Index face) {
    return four_reals(mesh.face(std::min(face, last)).plane.normal.data());
  };
  Four x = plane(f);
  Four y = plane(f + 1);
  Four z = plane(f + 2);
  Four offset = plane(f + 3);
  transpose(x, y, z, offset);
  return FourVectors{x, y, z}.dot(point) - offset;
}

/// The largest of numbers that are offered four at a time.
class WideSearch {
 public:
  /// @param first the number of the first of the four
  void offer(Four four, Index first) {
    const FourMask more = four > largest_;
    largest_ = more ? four : largest_;
    where_ = more ? FourMask{first, first + 1, first + 2, first + 3} : where_;
  }

  /// The smallest number of those with the largest value.
  Index first_largest() const {
    std::size_t best = 0;
    for (std::size_t lane = 1; lane < 4; ++lane) {
      const bool equal = largest_[lane] == largest_[best];
      if (largest_[lane] > largest_[best] || (equal && where_[lane] < where_[best])) best = lane;
    }
    return where_[best];
  }

 private:
  Four largest_ = four_times(-HUGE_VALF);
  FourMask where_ = {};
};

}  // namespace cs550
