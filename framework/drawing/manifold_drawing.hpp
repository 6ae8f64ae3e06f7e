#pragma once
/// @file manifold_drawing.hpp
/// **Lab 5:** Contact points. Document §3.6.

#include "cs550/contact.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// The points of a manifold in the world, without the bodies: a dot on A, a dot on B, the
/// separation between them, the normal and the first tangent.
/// @param a, b poses of the bodies
/// @param role of the points
/// @param length of the normal's arrow (m)
Drawing draw_manifold(const Pose& a, const Pose& b, const Manifold& manifold, Role role,
                      Real length);

/// The same with both bodies, and the outline of the points as a polygon.
Drawing draw_contact(const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                     Role role = Role::Highlight);

/// The name of a feature: "vertex 3 of B on face 2 of A".
std::string feature_text(FeatureId feature);

/// The reduction of many points to a few, to be viewed along the normal: all points with their
/// depth, and the kept points as a polygon.
/// @param points, kept anchors on A in its body frame
/// @param normal of the manifold in A's body frame, unit
Drawing draw_reduction(std::span<const ContactPoint> points, std::span<const ContactPoint> kept,
                       const Vec3& normal, Role role = Role::Highlight);

}  // namespace cs550::drawing
