#pragma once
/// @file shapes.hpp
/// The shapes that pages offer: recorded meshes, which need no lab's code.

#include <array>

#include "cs550/convex_shape.hpp"
#include "pages/base/content.hpp"

namespace cs550::pages {

/// What they are called.
inline constexpr std::array<const char*, 7> shape_names{
    "box", "tetrahedron", "prism", "dodecahedron", "hull16", "hull32", "icosphere"};

/// Their places in shape_names.
enum ShapeName : int { Box, Tetrahedron, Prism, Dodecahedron, Hull16, Hull32, Icosphere };

/// A shape of about 1 m. @param name place in shape_names
/// @throws std::runtime_error if its file is missing or damaged
ShapePtr recorded_shape(int name);

/// A pose from a position (m) and a turn about the fixed x, then y, then z axis (degrees).
Pose pose_from(const Vec3& position, const Vec3& turn_degrees);

/// A body for the painter.
Solid solid_of(const PosedShape& body, drawing::Role role, float opacity);

/// A mesh for the painter, in a light colour on which lines stand out. @param mesh valid
Solid light_solid(const HalfEdgeMesh& mesh);

/// A drawing made larger or smaller about the origin.
drawing::Drawing scaled(drawing::Drawing drawing, Real factor);

/// A drawing without the polygons and plain lines of a role: what a shaded body shows better.
drawing::Drawing without_faces(drawing::Drawing drawing, drawing::Role role);

/// The ball around a drawing and some bodies.
Focus focus_on(const drawing::Drawing& drawing, std::span<const PosedShape> bodies = {});

}  // namespace cs550::pages
