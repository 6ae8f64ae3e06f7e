// L2.4 and L2.5: outward planes.
#include <cs550/graded_test.hpp>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab2, InsideOutIsRefusedWhereverTheBodyIs, 2, "L2.4") {
  Story story("A body whose triangles all are clockwise seen from outside is refused");
  story.likely("the sign of the volume tells; abs() would hide it")
      .likely(
          "one triangle, or its side towards the origin, cannot tell: the origin may be outside")
      .likely("sum about a vertex: about a far origin the digits cancel");
  for (const TriangleSoup& soup : {tetrahedron_soup(1), cut_from_corners(box(Vec3(1, 2, 3))),
                                   cut_from_corners(dodecahedron()), icosphere_soup(1, 1)}) {
    for (const Vec3& shift :
         {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(-5, 30, -7), Vec3(1000, 2000, 500)}) {
      for (const Real scale : {Real(1), Real(1e-3), Real(1e3)}) {
        const TriangleSoup right = placed(soup, scale, Quat::Identity(), scale * shift);
        Story here = story;
        here.given("triangles", soup.triangles.size())
            .given("scale", scale)
            .given("shifted by " + Story::show(Vec3(scale * shift), "m"));
        require_mesh(right, here);
        TriangleSoup inside_out = right;
        for (Triangle& triangle : inside_out.triangles) std::swap(triangle[1], triangle[2]);
        here.given("all triangles reversed");
        require(expect_error(here, issue_of(inside_out), MeshError::InsideOut));
      }
    }
  }
}

GRADED_TEST(Lab2, FacesOfKnownSolidsHaveTheirPlanes, 2, "L2.4") {
  Story story("Faces have outward unit normals, and planes at the distances that geometry knows");
  story.likely("faces[f].plane has to be filled, by face_plane()");

  // Every face of the dodecahedron is at φ²/√(φ² + 1) from its centre; a centre off the origin adds
  // normal·centre.
  const double phi = (1 + std::sqrt(5.0)) / 2;
  const double inradius = phi * phi / std::sqrt(phi * phi + 1);
  const Vec3 centre(1, -2, Real(0.5));
  const HalfEdgeMesh mesh =
      require_mesh(placed(cut_from_corners(dodecahedron()), 1, Quat::Identity(), centre), story);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Plane& plane = mesh.face(f).plane;
    Story here = story;
    here.given("dodecahedron about " + Story::show(centre, "m")).given("face", f);
    // Coordinates of 3 m carry 2e-7 m of rounding; a triangle of it has edges above 1 m.
    require(here.expect_near("length of the normal", plane.normal.norm(), 1, 1e-5));
    require(
        here.expect_near("distance of the centre", plane.distance(centre), -inradius, 3e-6, "m"));
  }

  const HalfEdgeMesh tetrahedron = require_mesh(tetrahedron_soup(2), story);
  story.given("corner tetrahedron of side 2 m, its slanted face");
  const Plane& slanted = tetrahedron.face(3).plane;
  story.expect_near("normal", slanted.normal, Vec3::Ones() / std::sqrt(Real(3)), 1e-6);
  story.expect_near("offset", slanted.offset, 2 / std::sqrt(3.0), 1e-6, "m");
}

GRADED_TEST(Lab2, NewellFindsThePlaneOfRegularPolygons, 3, "L2.5") {
  Random random(25);
  Story story("A polygon in the plane n·x = d gives back n and d");
  story.seed(random.seed())
      .when("face_plane() of its front, then of its back")
      .likely("(a − c) × (b − c) for an edge from a to b: swapped, the normal points inward")
      .likely("offset is n·c with the unit normal")
      .likely(
          "far from the origin, sums of positions lose digits: take all of them relative to a "
          "point of the face");
  for (int i = 0; i < 60; ++i) {
    const int sides = random.integer(3, 40);
    const Real size = std::pow(Real(10), random.real(-3, 3));
    const Vec3 normal = random.unit_vector();
    const Vec3 middle = Real(i % 3) * 30 * size * random.unit_vector();
    const Vec3 u = any_perpendicular(normal);
    const Vec3 v = normal.cross(u);
    std::vector<Vec3> polygon;
    for (int k = 0; k < sides; ++k) {
      const Real angle = 2 * pi * static_cast<Real>(k) / static_cast<Real>(sides);
      polygon.push_back(middle + size * (std::cos(angle) * u + std::sin(angle) * v));
    }
    const HalfEdgeMesh mesh = two_sided(polygon);
    const Plane front = face_plane(mesh, 0);
    const Plane back = face_plane(mesh, 1);
    Story here = story;
    here.given("corners", sides).given("radius", size, "m").given("centre", middle, "m");
    // Each coordinate carries half a unit in its last place, 6e-8 of itself.
    const double rounding = 6e-8 * double(middle.norm() + size);
    require(
        here.expect_near("normal of the front", front.normal, normal, 1e-6 + 4 * rounding / size));
    require(
        here.expect_near("normal of the back", back.normal, -normal, 1e-6 + 4 * rounding / size));
    require(here.expect_near("length of the normal", front.normal.norm(), 1, 1e-6));
    for (const Vec3& corner : polygon) {
      require(
          here.expect_near("distance of a corner", front.distance(corner), 0, 8 * rounding, "m"));
    }
  }
}

GRADED_TEST(Lab2, NewellIsNotSpoiledByShortEdgesOrReflexCorners, 2, "L2.5") {
  Story story("The plane comes from all edges, each by the area that it spans with the centroid");
  story.when("polygon_plane(), with every corner once the first")
      .likely(
          "the cross product of the first two edges sees three corners only: they may lie on a "
          "line, turn inward, or be a micrometre apart")
      .likely(
          "normalise the sum once: unit normals of the parts would weigh a sliver like the rest")
      .likely("offset is that of the centroid of all corners, not of the first one");

  struct Case {
    const char* name;
    std::vector<Vec3> polygon;
  };
  const std::vector<Case> cases = {
      {"three corners on a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}},
      {"a corner that turns inward", {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}},
      {"a short edge that leaves the plane",
       {{0, 0, 0}, {2, 0, 0}, {2, Real(1e-4), Real(1e-4)}, {2, 2, 0}, {0, 2, 0}}},
      {"a square bent by a tenth", {{0, 0, 0}, {2, 0, Real(0.1)}, {2, 2, 0}, {0, 2, Real(0.1)}}},
      {"a pentagon, one corner lifted",
       {{0, 0, 0}, {3, 0, 0}, {4, 2, Real(0.2)}, {2, 4, 0}, {-1, 2, 0}}}};
  for (const Case& each : cases) {
    std::vector<Vec3> polygon = each.polygon;
    const Vec3d normal = area_vector(polygon).normalized();
    const double offset = normal.dot(centroid(polygon));
    for (std::size_t first = 0; first < polygon.size(); ++first) {
      const Plane plane = polygon_plane(polygon);
      Story here = story;
      here.given(each.name).given("first corner", polygon.front(), "m");
      // A few roundings of numbers up to 16 m², over areas of at least 4 m².
      require(here.expect_near("normal", plane.normal, normal.cast<Real>(), 2e-6));
      require(here.expect_near("offset", plane.offset, offset, 4e-6, "m"));
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
  }
}

}  // namespace
}  // namespace cs550::test
