#pragma once
/// @file outline.hpp
/// L5.1 for the engine: a polygon that is clipped in less time, with the same bits.

#include <array>
#include <cstdint>

#include "cs550/clipping.hpp"
#include "packed_vector.hpp"

namespace cs550::lab5 {

/// A ClipEdge in one word.
class EdgeName {
 public:
  EdgeName() = default;
  EdgeName(ClipEdge::Source source, Index edge)
      : bits_(static_cast<std::uint32_t>(edge) << 1 | static_cast<std::uint32_t>(source)) {}

  ClipEdge edge() const {
    return {static_cast<ClipEdge::Source>(bits_ & 1), static_cast<Index>(bits_ >> 1)};
  }

 private:
  std::uint32_t bits_;
};

/// A ClipPolygon.
class Outline {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  Packed point(std::size_t i) const { return points_[i]; }
  /// The edges that meet in a corner, as clip_polygon() names them.
  ClipVertex names(std::size_t i) const { return {{}, in_[i].edge(), out_[i].edge()}; }

  void push_back(Packed point, EdgeName in, EdgeName out) {
    write(point, in, out);
    ++size_;
  }

  /// Becomes another outline, clipped by a plane. Whether a corner is inside is hard to predict, so no branch depends on
  /// it: every corner and every intersection is written, and the next one overwrites those that the size does not count.
  /// @returns false, without a change, if all corners of the other one are inside, or if there is no room for the corners
  bool clip(const Outline& whole, const PackedPlane& plane, EdgeName plane_edge) {
    std::array<Real, capacity> distances;
    if (!measure(whole, plane, distances) || !fits(whole, distances)) return false;
    size_ = 0;
    Real before = distances[whole.size_ - 1];
    Real here = distances[0];
    for (std::size_t i = 0; i < whole.size_; ++i) {
      const std::size_t next = i + 1 < whole.size_ ? i + 1 : 0;
      const Real after = distances[next];
      const EdgeName in = whole.in_[i];
      const EdgeName out = whole.out_[i];

      const bool enters_here = here == 0 && before > 0 && after < 0;
      const bool leaves_here = here == 0 && before < 0 && after > 0;
      write(whole.points_[i], enters_here ? plane_edge : in, leaves_here ? plane_edge : out);
      size_ += static_cast<std::size_t>(here <= 0);

      const bool enters = here > 0 && after < 0;
      const bool leaves = here < 0 && after > 0;
      const Packed along = whole.points_[next] - whole.points_[i];
      const Packed intersection = whole.points_[i] + all(here / (here - after)) * along;
      write(intersection, leaves ? out : plane_edge, leaves ? plane_edge : out);
      size_ += static_cast<std::size_t>(enters || leaves);

      before = here;
      here = after;
    }
    return true;
  }

 private:
  /// One more than stay.
  static constexpr std::size_t capacity = static_cast<std::size_t>(ClipPolygon::capacity()) + 1;

  /// @returns whether a corner is outside. One that is not a number counts as outside, as in the teaching form.
  static bool measure(const Outline& whole, const PackedPlane& plane,
                      std::array<Real, capacity>& distances) {
    bool any_outside = false;
    for (std::size_t i = 0; i < whole.size_; ++i) {
      distances[i] = plane.distance(whole.points_[i]);
      any_outside |= !(distances[i] <= 0);
    }
    return any_outside;
  }

  /// Whether there is room for what the plane leaves. There is for convex faces, but rounding might let nearly parallel
  /// planes cut an outline that turns inward more often than straight lines do.
  static bool fits(const Outline& whole, const std::array<Real, capacity>& distances) {
    constexpr std::size_t of_convex_faces = 2 * static_cast<std::size_t>(max_face_vertices);
    if (whole.size_ < of_convex_faces) return true;
    std::size_t corners = 0;
    for (std::size_t i = 0; i < whole.size_; ++i) {
      const Real here = distances[i];
      const Real after = distances[i + 1 < whole.size_ ? i + 1 : 0];
      const bool crosses = (here < 0 && after > 0) || (here > 0 && after < 0);
      corners += static_cast<std::size_t>(here <= 0) + static_cast<std::size_t>(crosses);
    }
    return corners < capacity;
  }

  /// Behind the last corner.
  void write(Packed point, EdgeName in, EdgeName out) {
    points_[size_] = point;
    in_[size_] = in;
    out_[size_] = out;
  }

  std::size_t size_ = 0;
  std::array<Packed, capacity> points_;
  std::array<EdgeName, capacity> in_;
  std::array<EdgeName, capacity> out_;
};

}  // namespace cs550::lab5
