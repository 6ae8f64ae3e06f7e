#pragma once
/// @file face_bounds.hpp
/// Upper bounds of the separation along every face normal of A, from a few points of B.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "cs550/convex_shape.hpp"
#include "engine/wide_mesh.hpp"

namespace cs550 {

/// A face has at least three half-edges, so 3·F ≤ 2·E.
inline constexpr Index max_shape_faces = 2 * max_shape_edges / 3;

/// The distances of up to four points of B (witnesses) from every face of A. The separation along a
/// face normal is the *smallest* distance over all of B, so that of any one point bounds it.
class FaceBounds {
 public:
  /// Starts with one point of B.
  /// @param point in A's frame
  void start(const ConvexShape& a, const Vec3& point) {
    a_ = &a;
    count_ = 0;
    scan(point);
  }

  /// Adds another point. Precondition: not full.
  void add(const Vec3& point) { scan(point); }

  bool full() const { return count_ == capacity; }

  /// The first of the faces with the largest bound.
  Index largest() const { return largest_; }
  Real of(Index face) const { return block_of(face).smallest[lane_of(face)]; }

  /// Notes for every face which witnesses are less than `limit` outside it. Lanes past the last face get bits that
  /// nobody asks for.
  void compare_with(Real limit) {
    const Four wide_limit = four_times(limit);
    std::uint8_t* below = below_.data();
    for (const FourFaces& block : blocks()) {
      FourMask bits = {};
      for (std::size_t i = 0; i < count_; ++i) bits |= (block.distance[i] < wide_limit) & (1 << i);
      for (std::size_t lane = 0; lane < 4; ++lane) *below++ = static_cast<std::uint8_t>(bits[lane]);
    }
  }

  /// Whether some witness is less than the limit outside both faces. The limit then bounds s on the whole chord
  /// between their normals, along which the distance of the witness is linear. @pre compare_with()
  bool any_below(Index left, Index right) const {
    return (below_[static_cast<std::size_t>(left)] & below_[static_cast<std::size_t>(right)]) != 0;
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

  void scan(const Vec3& point) {
    constexpr Index few = 12;  // the search among four lanes takes longer than so few faces
    const std::size_t witness = count_++;
    if (a_->mesh.face_count() <= few) {
      scan_one_by_one(point, witness);
    } else {
      scan_by_fours(point, witness);
    }
  }

  void scan_one_by_one(const Vec3& point, std::size_t witness) {
    Real largest = -HUGE_VALF;
    for (Index f = 0; f < a_->mesh.face_count(); ++f) {
      FourFaces& block = block_of(f);
      const std::size_t lane = lane_of(f);
      const Real distance = a_->mesh.face(f).plane.distance(point);
      const Real bound = witness == 0 ? distance : std::min<Real>(block.smallest[lane], distance);
      block.distance[witness][lane] = distance;
      block.smallest[lane] = bound;
      if (bound > largest) {
        largest = bound;
        largest_ = f;
      }
    }
  }

  void scan_by_fours(const Vec3& point, std::size_t witness) {
    const FourVectors wide_point = four_times(point);
    Four largest = four_times(-HUGE_VALF);
    const PlaneBlock* planes = a_->plane_blocks.data();
    for (FourFaces& block : blocks()) {
      const Four distance = four_planes(*planes++).distance(wide_point);
      block.distance[witness] = distance;
      block.smallest = witness == 0 ? distance : smaller(distance, block.smallest);
      largest = larger(block.smallest, largest);
    }
    largest_ = first_with_bound(largest_lane(largest));
  }

  /// Lanes past the last face repeat it: it comes first, under its own number.
  Index first_with_bound(Real bound) {
    Index face = 0;
    for (const FourFaces& block : blocks()) {
      const FourMask equal = block.smallest == four_times(bound);
      if (any(equal)) return face + first_lane(equal);
      face += 4;
    }
    return 0;  // the pose is not a number
  }

  std::span<FourFaces> blocks() { return std::span(blocks_).first(a_->plane_blocks.size()); }

  const ConvexShape* a_ = nullptr;
  std::size_t count_ = 0;
  Index largest_ = 0;
  std::array<FourFaces, max_shape_faces / 4 + 1> blocks_;
  std::array<std::uint8_t, max_shape_faces + 4> below_;  ///< a bit for each witness
};

}  // namespace cs550
