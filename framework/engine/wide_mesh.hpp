#pragma once
/// @file wide_mesh.hpp
/// Vertices and planes of a mesh, four at a time. Every polyhedron has at least four vertices and four faces.

#include <cstdint>
#include <cstring>

#include "cs550/convex_shape.hpp"
#include "engine/lanes.hpp"

namespace cs550 {

/// Four numbers in one register.
using Four = lanes_of_four::Part;
using FourMask = lanes_of_four::PartMask;

/// The same number four times.
inline Four four_times(Real x) { return x - Four{}; }

inline Four larger(Four x, Four y) { return x > y ? x : y; }
inline Four smaller(Four x, Four y) { return x < y ? x : y; }

inline Real largest_lane(Four x) {
  const Four pairs = larger(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
  return larger(pairs, __builtin_shufflevector(pairs, pairs, 1, 0, 3, 2))[0];
}

inline Real smallest_lane(Four x) { return -largest_lane(-x); }

inline bool any(FourMask mask) {
  std::uint64_t words[2];
  std::memcpy(words, &mask, sizeof mask);
  return (words[0] | words[1]) != 0;
}

/// @pre any(mask)
inline Index first_lane(FourMask mask) {
  Index lane = 0;
  while (mask[static_cast<std::size_t>(lane)] == 0) ++lane;
  return lane;
}

struct FourVectors {
  Four x, y, z;

  Four dot(const FourVectors& o) const { return x * o.x + (y * o.y + z * o.z); }
};

inline FourVectors four_times(const Vec3& v) {
  return {four_times(v.x()), four_times(v.y()), four_times(v.z())};
}
inline FourVectors operator-(const FourVectors& v) { return {-v.x, -v.y, -v.z}; }

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

struct FourPlanes {
  FourVectors normal;
  Four offset;

  /// Plane::distance().
  Four distance(const FourVectors& point) const { return normal.dot(point) - offset; }
};

/// The plane of a face, from its block.
inline Plane plane_of(const ConvexShape& shape, Index face) {
  const auto i = static_cast<std::size_t>(face);
  const PlaneBlock& block = shape.plane_blocks[i / 4];
  const std::size_t lane = i % 4;
  return {{block.x[lane], block.y[lane], block.z[lane]}, block.offset[lane]};
}

inline FourPlanes four_planes(const PlaneBlock& block) {
  return {{four_reals(block.x.data()), four_reals(block.y.data()), four_reals(block.z.data())},
          four_reals(block.offset.data())};
}

}  // namespace cs550
