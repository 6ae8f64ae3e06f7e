#pragma once
/// @file clip_drawing.hpp
/// **Lab 5:** A polygon that is clipped by planes. Document §3.7.

#include "cs550/clipping.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// A polygon with a dot and a number at every corner, in the order of its corners.
/// @param opacity of its interior
Drawing draw_clip_polygon(const ClipPolygon& polygon, Role role, Real opacity = Real(0.35));

/// A plane as a strip: a line beside the polygon, and an arrow towards the side that is cut away.
/// @param near where the plane is drawn: the corners of the polygon that it clips
Drawing draw_clip_plane(const Plane& plane, std::span<const Vec3> near,
                        const std::string& name = "");

/// One clip: the polygon before (faint), the plane, and the polygon after.
Drawing draw_clip(const ClipPolygon& before, const Plane& plane, const ClipPolygon& after,
                  Role role = Role::Highlight);

/// The first `steps` clips: the reference face, its side planes, and the incident polygon before
/// and after.
/// @param reference corners of the reference face, counter-clockwise
/// @param planes its side planes, with outward normals
/// @param polygons the incident polygon, then the polygon after each plane: one more than planes
/// @param steps number of planes that have clipped
Drawing draw_clipping(std::span<const Vec3> reference, std::span<const Plane> planes,
                      std::span<const ClipPolygon> polygons, int steps);

/// The corners of a polygon.
std::vector<Vec3> corners(const ClipPolygon& polygon);

/// The unit normal of a polygon, or the z-axis if it has no area. Seen from there it is flat.
Vec3 polygon_normal(std::span<const Vec3> corners);

}  // namespace cs550::drawing
