#pragma once
/// @file face_bounds.hpp
/// Upper bounds of the separation along every face normal of A, from a few points of B.

#include <algorithm>
#include <array>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// A face has at least three half-edges, so 3·F ≤ 2·E.
inline constexpr Index max_shape_faces = 2 * max_shape_edges / 3;

/// The distances of up to four points of B (witnesses) from every face of A. The separation along a
/// face normal is the *smallest* distance over all of B, so that of any one point bounds it.
class FaceBounds {
 public:
  /// Starts with one point of B.
  /// @param point in A's frame
  void start(const HalfEdgeMesh& a, const Vec3& point) {
    count_ = 1;
    scan(a, [&](const Plane& plane, Bound& bound) {
      bound.distance[0] = plane.distance(point);
      bound.smallest = bound.distance[0];
    });
  }

  /// Adds another point. Precondition: not full.
  void add(const HalfEdgeMesh& a, const Vec3& point) {
    const std::size_t place = count_++;
    scan(a, [&](const Plane& plane, Bound& bound) {
      bound.distance[place] = plane.distance(point);
      bound.smallest = std::min(bound.smallest, bound.distance[place]);
    });
  }

  bool full() const { return count_ == capacity; }

  /// The first of the faces with the largest bound.
  Index largest() const { return largest_; }
  Real of(Index face) const { return bounds_[face].smallest; }

  /// Whether some witness is less than `limit` outside both faces. It then bounds s on the whole
  /// chord between their normals, along which its distance is linear.
  bool any_below(Index left, Index right, Real limit) const {
    const Bound& l = bounds_[left];
    const Bound& r = bounds_[right];
    for (std::size_t i = 0; i < count_; ++i) {
      if (std::max(l.distance[i], r.distance[i]) < limit) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t capacity = 4;

  struct Bound {
    std::array<Real, capacity> distance;
    Real smallest;
  };

  template <class Update>
  void scan(const HalfEdgeMesh& a, const Update& update) {
    Real largest = -HUGE_VALF;
    for (Index f = 0; f < a.face_count(); ++f) {
      Bound& bound = bounds_[f];
      update(a.face(f).plane, bound);
      if (bound.smallest > largest) {
        largest = bound.smallest;
        largest_ = f;
      }
    }
  }

  std::size_t count_ = 0;
  Index largest_ = 0;
  std::array<Bound, max_shape_faces> bounds_;
};

}  // namespace cs550
