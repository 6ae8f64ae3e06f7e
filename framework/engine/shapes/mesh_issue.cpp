#include "cs550/half_edge_mesh.hpp"

namespace cs550 {
namespace {

std::string number(Index i) { return i == no_index ? "(none named)" : std::to_string(i); }

}  // namespace

std::string describe(const MeshIssue& issue) {
  const std::string triangle = "triangle " + number(issue.triangle);
  const std::string both =
      "triangles " + number(issue.triangle) + " and " + number(issue.other_triangle);
  const std::string vertex = "vertex " + number(issue.vertex);
  const std::string edge = "edge " + number(issue.edge[0]) + "–" + number(issue.edge[1]);

  switch (issue.error) {
    case MeshError::None:
      return "nothing is wrong with the triangles";
    case MeshError::NoTriangles:
      return "there are no triangles";
    case MeshError::NonFiniteVertex:
      return vertex + " has a coordinate that is infinite or not a number";
    case MeshError::IndexOutOfRange:
      return triangle + " names a vertex that does not exist: " + number(issue.vertex);
    case MeshError::DegenerateTriangle:
      return triangle + " names a vertex twice or has no area: remove it";
    case MeshError::DuplicateTriangle:
      return both + " have the same three vertices: remove one of them";
    case MeshError::IsolatedVertex:
      return vertex + " belongs to no triangle: remove it";
    case MeshError::OpenEdge:
      return edge + " belongs to " + triangle + " only: the surface is open there, close the hole";
    case MeshError::NonManifoldEdge:
      return edge + " belongs to three triangles or more, among them " + both +
             ": remove those inside the solid";
    case MeshError::InconsistentWinding:
      return both + " run along " + edge + " in the same direction: reverse one of them";
    case MeshError::InsideOut:
      return "the triangles are clockwise seen from outside: reverse all of them";
  }
  return "unknown fault";
}

}  // namespace cs550
