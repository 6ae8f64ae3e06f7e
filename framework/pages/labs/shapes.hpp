#pragma once
/// @file shapes.hpp
/// The shapes of the pages: recorded meshes, which need no lab's code.

#include <array>

#include "cs550/convex_shape.hpp"
#include "pages/base/camera.hpp"
#include "pages/base/content.hpp"

namespace cs550::pages {

/// The names of the shapes.
inline constexpr std::array<const char*, 7> shape_names{
    "box", "tetrahedron", "prism", "dodecahedron", "hull16", "hull32", "icosphere"};

/// Their indices in shape_names.
enum ShapeName : int { Box, Tetrahedron, Prism, Dodecahedron, Hull16, Hull32, Icosphere };

/// A recorded shape. @param name index in shape_names @param radius of the shape (m)
/// @throws std::runtime_error if its file is missing or damaged
ShapePtr recorded_shape(int name, Real radius = 1);

/// A pose from a position (m) and a turn about the fixed x, then y, then z axis (degrees).
Pose pose_from(const Vec3& position, const Vec3& turn_degrees);

/// The turn with which pose_from() makes an orientation (degrees), each between −180 and 180.
Vec3 turn_degrees(const Quat& orientation);

/// A body as a solid.
Solid solid_of(const PosedShape& body, drawing::Role role, float opacity);

/// A mesh as a solid, in a light colour on which lines stand out. @pre mesh is valid
Solid light_solid(const HalfEdgeMesh& mesh);

/// A drawing scaled about the origin.
drawing::Drawing scaled(drawing::Drawing drawing, Real factor);

/// A drawing without the polygons and plain lines of a role, for use with a shaded body.
drawing::Drawing without_faces(drawing::Drawing drawing, drawing::Role role);

/// A focus that is closer by a factor, but shows the bodies completely.
/// @param view the direction from which they are seen
Focus closer(Focus focus, Real factor, std::span<const PosedShape> bodies, const Camera& view);

/// The ball around a drawing and bodies.
Focus focus_on(const drawing::Drawing& drawing, std::span<const PosedShape> bodies = {});

}  // namespace cs550::pages
