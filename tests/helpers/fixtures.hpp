#pragma once
/// @file fixtures.hpp
/// Recorded shapes: data, so that a lab's tests need no other lab. See recorded_meshes.hpp for what
/// each one is.

#include <string>
#include <string_view>

#include "cs550/convex_shape.hpp"

namespace cs550::test {

/// The file of a mesh: in framework/assets/meshes if scenes use it, too, else in tests/fixtures/meshes.
std::string fixture_file(const std::string& name);

/// The mesh in that file, read once.
/// @throws std::runtime_error if there is none of that name
const HalfEdgeMesh& fixture_mesh(std::string_view name);

/// The shape made of that mesh: the same one for every caller.
/// @throws std::runtime_error if there is none of that name, or the mesh is not convex
ShapePtr fixture_shape(const std::string& name);

}  // namespace cs550::test
