#pragma once
/// @file face_bounds.hpp
/// Upper bounds of the separation along every face normal of A, from a few points of B.

#include <algorithm>
#include <array>

#include "cs550/convex_shape.hpp"
#include "wide_mesh.hpp"

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
    count_ = 0;
    scan(a, point);
  }

  /// Adds another point. Precondition: not full.
  void add(const HalfEdgeMesh& a, const Vec3& point) { scan(a, point); }

  bool full() const { return count_ == capacity; }

  /// The first of the faces with the largest bound.
  Index largest() const { return largest_; }
  Real of(Index face) const { return block_of(face).smallest[lane_of(face)]; }

  /// Whether some witness is less than `limit` outside both faces. It then bounds s on the whole
  /// chord between their normals, along which its distance is linear.
  bool any_below(Index left, Index right, Real limit) const {
    const FourFaces& l = block_of(left);
    const FourFaces& r = block_of(right);
    const std::size_t lane_l = lane_of(left);
    const std::size_t lane_r = lane_of(right);
    for (std::size_t i = 0; i < count_; ++i) {
      if (std::max(l.distance[i][lane_l], r.distance[i][lane_r]) < limit) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t capacity = 4;

  /// Four faces, one in each lane.
  struct FourFaces {
    std::array<Four, capacity> distance;
    Four smallest;
  };

  static std::size_t lane_of(Index face) { return static_cast<std::size_t>(face) % 4; }
  const FourFaces& block_of(Index face) const {
    return blocks_[static_cast<std::size_t>(face) / 4];
  }
  FourFaces& block_of(Index face) { return blocks_[static_cast<std::size_t>(face) / 4]; }

  void scan(const HalfEdgeMesh& a, const Vec3& point) {
    constexpr Index few = 12;  // the search among four lanes takes longer than so few faces
    const std::size_t witness = count_++;
    if (a.face_count() <= few) {
      scan_one_by_one(a, point, witness);
    } else {
      scan_by_fours(a, point, witness);
    }
  }

  void scan_one_by_one(const HalfEdgeMesh& a, const Vec3& point, std::size_t witness) {
    Real largest = -HUGE_VALF;
    for (Index f = 0; f < a.face_count(); ++f) {
      FourFaces& block = block_of(f);
      const std::size_t lane = lane_of(f);
      const Real distance = a.face(f).plane.distance(point);
      const Real bound = witness == 0 ? distance : std::min<Real>(block.smallest[lane], distance);
      block.distance[witness][lane] = distance;
      block.smallest[lane] = bound;
      if (bound > largest) {
        largest = bound;
        largest_ = f;
      }
    }
  }

  void scan_by_fours(const HalfEdgeMesh& a, const Vec3& point, std::size_t witness) {
    constexpr Index four = 4;
    const FourVectors wide_point = four_times(point);
    WideSearch search;
    for (Index f = 0; f < a.face_count(); f += four) {
      FourFaces& block = block_of(f);
      const Four distance = four_distances(a, f, wide_point);
      block.distance[witness] = distance;
      block.smallest =
          witness == 0 ? distance : (distance < block.smallest ? distance : block.smallest);
      search.offer(block.smallest, f);
    }
    // Lanes past the last face repeat it. It was offered first, so it wins under its own number.
    largest_ = search.first_largest();
  }

  std::size_t count_ = 0;
  Index largest_ = 0;
  std::array<FourFaces, max_shape_faces / 4 + 1> blocks_;
};

}  // namespace cs550
