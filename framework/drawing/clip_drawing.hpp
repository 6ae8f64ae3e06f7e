#pragma once
/// @file clip_drawing.hpp
/// **Lab 5:** A polygon, and what planes leave of it. Document §3.7.

#include "cs550/clipping.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// A polygon with a dot and a number at every corner, in the order of its corners.
/// @param opacity of its inside
Drawing draw_clip_polygon(const ClipPolygon& polygon, Role role, Real opacity = Real(0.35));

/// A plane as a strip that stands on it: a line where it passes by the polygon, and an arrow to the
/// side that is cut away.
/// @param near positions along which the plane is shown: those of the polygon that it clips
Drawing draw_clip_plane(const Plane& plane, std::span<const Vec3> near,
                        const std::string& name = "");

/// One clip: the polygon before, faint, the plane, and what is left.
Drawing draw_clip(const ClipPolygon& before, const Plane& plane, const ClipPolygon& after,
                  Role role = Role::Highlight);

/// All clips up to one: the reference face, its side planes, the incident polygon as it came, and
/// what the first `steps` planes left of it.
/// @param reference corners of the reference face, counter-clockwise
/// @param planes its side planes, normals outward
/// @param polygons the incident polygon, then what each plane left: one more than planes
/// @param steps how many planes have clipped
Drawing draw_clipping(std::span<const Vec3> reference, std::span<const Plane> planes,
                      std::span<const ClipPolygon> polygons, int steps);

/// The corners of a polygon.
std::vector<Vec3> corners(const ClipPolygon& polygon);

/// The normal of a polygon (unit), or z of one without area: from where it is seen flat.
Vec3 polygon_normal(std::span<const Vec3> corners);

}  // namespace cs550::drawing
