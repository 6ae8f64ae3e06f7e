#pragma once
/// @file gauss_map_drawing.hpp
/// **Lab 4:** Gauss maps, and the axis between two bodies. Document §3.2–3.5; Gregorius, *The
/// Separating Axis Test between Convex Polyhedra* (GDC 2013).

#include "cs550/separating_axis.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// An edge on the Gauss map: the great-circle arc between the normals of the two faces beside it.
struct GaussArc {
  Index edge = no_index;     ///< the half-edge with the even number
  Vec3 from = Vec3::Zero();  ///< normal of the face on its left: unit, world frame
  Vec3 to = Vec3::Zero();    ///< normal of the face of its twin
};

/// The arcs of all edges. @param negated whether they are those of −B, with reversed normals
std::vector<GaussArc> gauss_arcs(const PosedShape& body, bool negated = false);

/// Points along the shorter great circle between two points of the unit sphere, at most 3° apart
/// and including the ends. @param from, to unit
std::vector<Vec3> arc_points(const Vec3& from, const Vec3& to);

/// A pair of edges whose arcs cross.
struct EdgePair {
  Index edge_a = no_index;  ///< half-edge of A
  Index edge_b = no_index;  ///< half-edge of B
};

/// The unit sphere on which Gauss maps are drawn.
Drawing draw_unit_sphere();

/// A Gauss map: a dot for each face, an arc for each edge, without the sphere.
Drawing draw_gauss_map(const PosedShape& body, Role role, bool negated = false);

/// Two arcs on the sphere, the arguments of is_minkowski_face(), and whether they cross.
/// @param a, b ends of the arc of A; @param c, d ends of the arc of −B
Drawing draw_arc_pair(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The maps of A and −B on one sphere. Crossing pairs are highlighted, and the axis is an arrow.
/// @param axis none is drawn if its feature is None
Drawing draw_gauss_maps(const PosedShape& a, const PosedShape& b, std::span<const EdgePair> pairs,
                        const SeparatingAxis& axis = {});

/// The name of a separating axis: "face 3 of A", "edges 4 and 10".
std::string feature_text(const SeparatingAxis& axis);

/// Both bodies in the world, the axis with its highlighted features, and the separation along it.
/// Features that do not exist are left out, with a note.
/// @param role of the axis and its features: Highlight, or Expected beside Got
Drawing draw_axis(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                  Role role = Role::Highlight);

}  // namespace cs550::drawing
