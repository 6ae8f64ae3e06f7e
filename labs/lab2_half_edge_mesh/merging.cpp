/// @file merging.cpp
/// Lab 2, L2.6 to L2.9: coplanar triangles become convex polygons. The handout is README.md in
/// this folder. The contract is in framework/include/cs550/half_edge_mesh.hpp.

#include "cs550/half_edge_mesh.hpp"
#include "cs550/not_implemented.hpp"

namespace cs550 {

HalfEdgeMesh merge_coplanar_faces([[maybe_unused]] const HalfEdgeMesh& mesh,
                                  [[maybe_unused]] Real tolerance) {
  // L2.6: Write down the loop that two faces would have without their shared edge. Decide whether
  // it may be a face before you change the mesh.
  // L2.7: Remove the vertices that are left with two edges.
  // L2.8: Extend the loop at reflex vertices, and remove chains of shared edges.
  // L2.9: Try the edges in an order that does not depend on the order of the triangles.
  throw NotImplemented("L2.6");
}

}  // namespace cs550
