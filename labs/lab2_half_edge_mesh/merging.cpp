/// @file merging.cpp
/// Lab 2, L2.6 and L2.7: coplanar triangles become convex polygons. The handout is README.md, beside
/// this file; what each function promises stands in framework/include/cs550/half_edge_mesh.hpp.

#include "cs550/half_edge_mesh.hpp"
#include "cs550/not_implemented.hpp"

namespace cs550 {

HalfEdgeMesh merge_coplanar_faces([[maybe_unused]] const HalfEdgeMesh& mesh,
                                  [[maybe_unused]] Real tolerance) {
  // L2.6, step 1: how far may a vertex be from a plane, in metres, in a mesh of this size?
  // L2.6, step 2: visit the edges in an order that does not depend on their numbers.
  // L2.6, step 3: write down the loop that the two faces would have without the edge. Decide with
  //               polygon_plane() of *its* corners, before you change anything, whether it may be a
  //               face.
  // L2.6, step 4: link the loop, and mark what is gone: the face of both half-edges of the edge, and
  //               the edge of one of the two faces, become no_index.
  // L2.6, step 5: without_removed() is given: it makes a mesh of what is left. Renew its planes.
  //
  // L2.7, step 1: the loop of step 3 may run along an edge and straight back. What is that edge?
  // L2.7, step 2: the loop may have a reflex vertex that other faces of the same plane fill.
  // L2.7, step 3: a vertex may be left with two edges on a straight line. Two faces lose it.
  // L2.7, step 4: what must hold so that a second call finds nothing to do?
  // See README.md, L2.6 and L2.7.
  throw NotImplemented("L2.6");
}

}  // namespace cs550
