// L2.6: merging two coplanar faces.
#include <cs550/graded_test.hpp>
#include <initializer_list>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab2, BoxesAndPrismsMergeToTheirPolygons, 4, "L2.6") {
  Story story("A prism over an n-gon has n + 2 faces, 3n edges and 2n vertices after merging");
  story.when("merge_coplanar_faces(build_half_edge_mesh(…))")
      .likely("coplanar triangles have stayed apart: each cuts a contact polygon short in lab 5")
      .likely(
          "the loop without the edge: prev of the one half-edge leads on to next of its twin, and "
          "the other way round")
      .likely("all half-edges of the second face must learn the name of the first")
      .likely("prev has to follow as well as next, and both halves of a removed edge are marked")
      .likely("a repeated pass begins with the mesh that the last pass has left");
  for (const int n : {3, 4, 5, 6, 12, 60}) {
    const Real radius = 2;
    const Real half_height = Real(0.5);
    Story here = story;
    here.given("prism over a regular n-gon, n", n).given("triangles", 4 * n - 4);
    const HalfEdgeMesh built = require_mesh(prism_soup(n, radius, half_height), here);
    const HalfEdgeMesh mesh = merge_coplanar_faces(built);
    here.picture([&] { return merge_picture(built, mesh); });
    require(expect_counts(here, mesh, 2 * n, 3 * n, n + 2));
    require(expect_valid(here, mesh));

    // The area of a regular n-gon in a circle of radius r is ½·n·r²·sin(2π/n).
    const double cap = 0.5 * n * radius * radius * std::sin(2 * M_PI / n);
    const double side = 2 * half_height * 2 * radius * std::sin(M_PI / n);
    Index caps = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Plane& plane = mesh.face(f).plane;
      const bool is_cap = std::abs(plane.normal.z()) > Real(0.5);
      caps += is_cap ? 1 : 0;
      here.given("face", f);
      here.expect_equal("corners", static_cast<int>(loop_of(mesh, f).size()), is_cap ? n : 4);
      here.expect_near("area", area_vector(corners(mesh, f)).norm(), is_cap ? cap : side,
                       1e-5 * (is_cap ? cap : side), "m²");
      here.expect_near("offset of the plane", plane.offset,
                       is_cap ? double(half_height) : radius * std::cos(M_PI / n), 1e-5, "m");
    }
    here.expect_equal("caps", caps, 2);
  }

  const HalfEdgeMesh sphere = require_mesh(icosphere_soup(2, 1), story);
  Story untouched("Where nothing is coplanar, nothing changes");
  untouched.given("icosphere of 320 triangles")
      .likely("edges are up to 18° sharp here: how is a face told from a coplanar one?");
  expect_same_faces(untouched, merge_coplanar_faces(sphere), sphere);
}

/// A box of 2 m × 2 m with a ridge along the middle of its top, like a very low roof.
TriangleSoup roofed_box(Real half_thickness, Real height) {
  Solid solid = box({1, 1, half_thickness});
  const Real top = half_thickness + height;
  solid.vertices.insert(solid.vertices.end(), {{0, -1, top}, {0, 1, top}});
  solid.polygons = {{3, 2, 1, 0}, {4, 8, 9, 7},    {8, 5, 6, 9}, {8, 4, 0, 1, 5},
                    {1, 2, 6, 5}, {9, 6, 2, 3, 7}, {3, 0, 4, 7}};
  return cut_from_corners(solid);
}

/// The dimensions of a box with a ridge.
struct Roof {
  Real half_thickness;  ///< over half the width
  Quat orientation;
  Real scale;
  Real tolerance;
};

/// Checks that merging flattens a ridge of these heights, or keeps it. @param shares heights over the slack
void require_ridges(const Story& story, const Roof& roof, std::initializer_list<Real> shares,
                    bool are_kept) {
  for (const Real share : shares) {
    const Real height = share * roof.tolerance * 2;
    const TriangleSoup soup =
        placed(roofed_box(roof.half_thickness, height), roof.scale, roof.orientation, Vec3::Zero());
    Story here = story;
    here.given("width of the box", 2 * roof.scale, "m")
        .given("thickness over width", roof.half_thickness)
        .given("tolerance", roof.tolerance)
        .given("height of the ridge over the width", height / 2);
    const HalfEdgeMesh built = require_mesh(soup, here);
    const HalfEdgeMesh mesh = merge_coplanar_faces(built, roof.tolerance);
    require(here.expect_equal("faces", mesh.face_count(), are_kept ? 7 : 6));
    // The ends of a removed ridge have two edges left. L2.7 removes them.
    if (are_kept) require(expect_valid(here, mesh, 2 * roof.tolerance + Real(1e-4)));
  }
}

GRADED_TEST(Lab2, ToleranceIsRelativeToTheSizeOfTheMesh, 3, "L2.6") {
  require_linked_merge();
  Random random(26);
  Story story("A low ridge on a box is merged or kept by its height over the size of the box");
  story.seed(random.seed())
      .likely("the tolerance is relative: multiply it by the *largest* extent, in metres")
      .likely("an extent is the whole width of the bounds, not the half")
      .likely("it bounds a distance, not an angle: equal normals within 1e-5 are another question");
  // The top's four corners and the ridge's two ends lie at −h/3 and +2h/3 from their common plane,
  // the corners of two triangles across the ridge at ±h/2, the ridge h above the plane of the
  // corners: up to one slack and beyond two, the order of merging is irrelevant.
  for (const Real tolerance : {coplanar_tolerance, Real(1e-3)}) {
    for (const Real scale : {Real(1), Real(1e-3), Real(1e3)}) {
      // The extents of a turned box are up to √3 times its width.
      const Roof turned{1, random.orientation(), scale, tolerance};
      require_ridges(story, turned, {Real(0.25), Real(0.9)}, false);
      require_ridges(story, turned, {4}, true);
      // A box and a plate, whose smallest extent is a hundredth of its largest.
      for (const Real half_thickness : {Real(1), Real(0.01)}) {
        const Roof upright{half_thickness, Quat::Identity(), scale, tolerance};
        require_ridges(story, upright, {Real(0.25), Real(0.9)}, false);
        require_ridges(story, upright, {Real(2.2), 4}, true);
      }
    }
  }
}

}  // namespace
}  // namespace cs550::test
