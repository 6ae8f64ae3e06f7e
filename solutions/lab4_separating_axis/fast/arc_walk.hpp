#pragma once
/// @file arc_walk.hpp
/// An edge of A as a chord between two face normals, walked over the Gauss map of B.

#include <algorithm>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// An edge of A in B's frame. Its arc on the Gauss map is taken as the chord
/// n(t) = (1 − t)·from + t·to, along which s(n(t)) = min over B of n·v − n·p is concave and
/// piecewise linear. p is any point of the edge; where rounding or merging left the normals not
/// quite perpendicular to it, the end farther along n.
struct Arc {
  Vec3 from;
  Vec3 to;
  Vec3 tail;
  Vec3 head;

  Vec3 normal(Real t) const { return from + t * (to - from); }

  /// n·(v − p), not divided by |n|.
  Real separation(const Vec3& n, const Vec3& v) const {
    return n.dot(v) - std::max(n.dot(tail), n.dot(head));
  }

  /// Whether a crossing on this arc can separate by more than `floor`, given that a face is known
  /// to separate by as much as either end does.
  /// @param at_from, at_to B's support vertices against the ends
  bool may_beat(Real floor, const Vec3& at_from, const Vec3& at_to) const {
    const Real begin = separation(from, at_from);
    const Real end = separation(to, at_to);
    const Vec3 chord = to - from;
    const Real rise = separation_slope(chord, at_from);
    const Real fall = separation_slope(chord, at_to);

    // s lies below its tangents at both ends; between them it peaks where they meet, at most.
    Real bound = std::max(begin, end);
    if (rise > 0 && fall < 0) {
      const Real t = std::clamp((end - fall - begin) / (rise - fall), Real(0), Real(1));
      bound = std::max(bound, begin + t * rise);
    } else if (bound <= 0) {
      return false;  // without a peak, s/|n| ≤ s ≤ the better end
    }
    if (bound <= 0) return bound > floor;
    return bound > floor * shortest_normal();
  }

  /// Whether the ends are so nearly opposite that rounding decides the order of the crossings: the chord comes
  /// close to the origin, where its normals turn at once. The edges of a thin disc's rim are such.
  bool is_nearly_half_a_circle() const { return shortest_normal() < Real(5e-3); }

  /// Whether the crossing at t, of an edge of B through v, separates by more than `floor`. Says yes
  /// where |n(t)| is too small to tell.
  bool may_separate_by(Real floor, Real t, const Vec3& v) const {
    constexpr Real reliable_length = Real(0.1);
    const Vec3 n = normal(t);
    const Real length = n.norm();
    return length < reliable_length || separation(n, v) > floor * length;
  }

 private:
  /// |n(½)|. From the sum, which is exact where the ends are nearly opposite.
  Real shortest_normal() const { return (from + to).norm() / 2; }

  Real separation_slope(const Vec3& chord, const Vec3& v) const { return chord.dot(v - tail); }
};

/// Visits the crossings of an arc of A with the arcs of B, in order: the places where B's vertex
/// farthest against n(t) changes. From vertex v the next one is the neighbour w with the smallest t
/// at which n(t)·(w − v) turns negative. Every step goes strictly down along `arc.to`, so it ends.
/// @param start B's support vertex against arc.from
/// @param visit called with t and the half-edge of B from v to w
template <class Visit>
void walk_arc(const HalfEdgeMesh& b, const Arc& arc, Index start, const Visit& visit) {
  Real t = 0;
  for (Index v = start; v != no_index;) {
    const Real height_from = arc.from.dot(b.vertex(v));
    const Real height_to = arc.to.dot(b.vertex(v));
    Index next_edge = no_index;
    Real next_t = 1;
    Real next_slope = 0;
    for (const Index e : vertex_edges(b, v)) {
      const Vec3& w = b.vertex(b.edge(e).vertex);
      const Real at_to = arc.to.dot(w) - height_to;
      if (at_to >= 0) continue;
      const Real at_from = std::max(Real(0), arc.from.dot(w) - height_from);
      const Real slope = at_to - at_from;
      const Real crossing = std::max(t, -at_from / slope);
      if (crossing < next_t || (crossing == next_t && slope < next_slope)) {
        next_edge = e;
        next_t = crossing;
        next_slope = slope;
      }
    }
    if (next_edge == no_index) return;
    t = next_t;
    visit(t, next_edge);
    v = b.edge(next_edge).vertex;
  }
}

}  // namespace cs550
