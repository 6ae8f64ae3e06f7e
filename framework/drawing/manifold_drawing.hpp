#pragma once
/// @file manifold_drawing.hpp
/// **Lab 5:** Contact points. Document §3.6.

#include "cs550/contact.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// The points of a manifold in the world: a dot on A, a dot on B, the separation between them, the
/// normal and the first tangent. Without the bodies.
/// @param a, b the bodies' poses
/// @param role of the points
/// @param length of the normal's arrow (m)
Drawing draw_manifold(const Pose& a, const Pose& b, const Manifold& manifold, Role role,
                      Real length);

/// The same with both bodies, and the outline of the points as a polygon.
Drawing draw_contact(const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                     Role role = Role::Highlight);

/// Which features meet: "vertex 3 of B on face 2 of A".
std::string feature_text(FeatureId feature);

/// The reduction of many points to a few, seen along the normal: all of them with their depth, the
/// kept ones as a polygon.
/// @param points, kept anchors on A in its body frame
/// @param normal of the manifold in A's body frame, unit
Drawing draw_reduction(std::span<const ContactPoint> points, std::span<const ContactPoint> kept,
                       const Vec3& normal, Role role = Role::Highlight);

}  // namespace cs550::drawing
