#pragma once
/// @file contacts.hpp
/// Bodies, polygons and axes for the tests of lab 5, and checks of a manifold in double precision,
/// without the code under test.

#include <string>
#include <vector>

#include "cs550/clipping.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

using Point = Eigen::Vector3d;

inline std::string name_of(AxisFeature feature) {
  constexpr const char* names[] = {"no feature", "A's face", "B's face", "the edges"};
  return names[static_cast<int>(feature)];
}

/// A feature id in words, such as "VertexOnFaceA 3/5".
std::string name_of(const FeatureId& id);

/// A fixture, `scale` times as large.
ShapePtr scaled_shape(const std::string& fixture, Real scale);

/// A posed shape that owns its shape.
struct Placed {
  ShapePtr shape;
  PosedShape body;

  Placed(ShapePtr of, const Pose& pose) : shape(std::move(of)), body{shape.get(), pose} {}
};

/// A rotation about an axis. @param degrees right-handed
Quat turned(Real degrees, const Vec3& axis);

/// The pose `inner`, given relative to `outer`, in the frame of `outer` itself.
Pose composed(const Pose& outer, const Pose& inner);

/// The face with the normal closest to a direction in the body frame.
Index face_towards(const HalfEdgeMesh& mesh, const Vec3& direction);
/// The vertex at a position in the body frame.
Index vertex_at(const HalfEdgeMesh& mesh, const Vec3& place);
/// The faces that have a corner at a vertex.
std::vector<Index> faces_at(const HalfEdgeMesh& mesh, Index vertex);
/// The half-edge from one vertex to another.
Index edge_between(const HalfEdgeMesh& mesh, Index from, Index to);

/// The axis of a face of A (FaceA) or of B (FaceB), with its query filled in by brute force.
SeparatingAxis face_axis(const PosedShape& a, const PosedShape& b, AxisFeature feature, Index face);
/// The axis of two edges, oriented by the middles of the bodies.
SeparatingAxis edge_axis(const PosedShape& a, const PosedShape& b, Index edge_a, Index edge_b);

Point in_world(const PosedShape& body, const Vec3& point);
/// The position of a contact point on A, on B, and half-way.
Point on_a(const PosedShape& a, const ContactPoint& point);
Point on_b(const PosedShape& b, const ContactPoint& point);
Point middle(const PosedShape& a, const PosedShape& b, const ContactPoint& point);

/// The distance of a world point outside a body: the maximum over its faces.
double outside(const PosedShape& body, const Point& point);
/// min n·(vertices of B) − max n·(vertices of A): the separation along n.
double separation_along(const PosedShape& a, const PosedShape& b, const Vec3& n);

Real deepest_separation(const Manifold& manifold);

/// The area of the convex polygon of these points, in any order, seen along a normal.
double area_of(const std::vector<Point>& points, const Point& normal);

/// Checks that the midpoints of the contact points are these positions, in any order.
bool expect_points(Story story, const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                   const std::vector<Vec3>& expected, Real tolerance, SourceLine at = {});

/// Checks that the tangent is parallel to an edge.
/// @param edge_name in words: "A's edge"
/// @param edge world frame, of any length
bool expect_tangent_along(Story& story, const Manifold& manifold, const std::string& edge_name,
                          const Vec3& edge, SourceLine at = {});

/// Checks the invariants of a manifold: unit normal and tangent at right angles, separation =
/// n·(point on B − point on A), both anchors on (or in) their bodies.
/// @param size of the pair (m), to which rounding is relative
void require_sound(Story story, const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                   Real size, SourceLine at = {});

}  // namespace cs550::test
