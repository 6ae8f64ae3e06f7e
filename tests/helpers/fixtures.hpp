#pragma once
/// @file fixtures.hpp
/// Recorded shapes. They are data, so that a lab's tests need no other lab. recorded_meshes.hpp
/// describes them.

#include <string>
#include <string_view>

#include "cs550/convex_shape.hpp"

namespace cs550::test {

/// The file of a mesh: in framework/assets/meshes if scenes use it, else in tests/fixtures/meshes.
std::string fixture_file(const std::string& name);

/// The mesh in that file, read once.
/// @throws std::runtime_error if there is no mesh of that name
const HalfEdgeMesh& fixture_mesh(std::string_view name);

/// The shape of that mesh, shared by all callers.
/// @throws std::runtime_error if there is no mesh of that name, or it is not convex
ShapePtr fixture_shape(const std::string& name);

}  // namespace cs550::test
