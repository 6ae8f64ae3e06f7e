// L2.1 to L2.5 again, with other sizes, places and seeds.
#include <cs550/graded_test.hpp>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab2, OneFaultAmongThousandsIsFound, 3, "L2.2") {
  Random random(221);
  Story story("One fault among thousands of triangles is found, and named");
  story.seed(random.seed())
      .given("icosphere of 81920 triangles")
      .likely("comparing all pairs of triangles takes minutes: sort, or use a map");
  const TriangleSoup whole = icosphere_soup(6, 1);
  const Index count = static_cast<Index>(whole.triangles.size());
  for (int i = 0; i < 3; ++i) {
    const Index chosen = random.integer(0, count - 1);

    TriangleSoup reversed = whole;
    std::swap(reversed.triangles[chosen][1], reversed.triangles[chosen][2]);
    MeshIssue issue = issue_of(reversed);
    Story here = story;
    here.given("triangle " + std::to_string(chosen) + " is reversed");
    expect_error(here, issue, MeshError::InconsistentWinding);
    here.expect("it is named", issue.triangle == chosen || issue.other_triangle == chosen);

    TriangleSoup repeated = whole;
    const auto [a, b, c] = whole.triangles[chosen];
    repeated.triangles.push_back({c, a, b});
    issue = issue_of(repeated);
    here = story;
    here.given("triangle " + std::to_string(chosen) + " is there twice");
    expect_error(here, issue, MeshError::DuplicateTriangle);
    here.expect_equal("the first", std::min(issue.triangle, issue.other_triangle), chosen);
    here.expect_equal("the second", std::max(issue.triangle, issue.other_triangle), count);

    TriangleSoup open = whole;
    open.triangles.erase(open.triangles.begin() + chosen);
    issue = issue_of(open);
    here = story;
    here.given("triangle " + std::to_string(chosen) + " is missing");
    expect_error(here, issue, MeshError::OpenEdge);
    for (const Index v : issue.edge) {
      here.expect("the edge lies at the hole", v == a || v == b || v == c);
    }
  }
}

GRADED_TEST(Lab2, HullsOfSphericalCloudsAreClosed, 3, "L2.3") {
  Story story(
      "n points on a sphere give 2n − 4 triangles and 3n − 6 edges, wherever and however large");
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const int n = random.integer(4, 300);
    const Real size = std::pow(Real(10), random.real(-3, 3));
    const SoupResult hull = convex_hull(random_sphere_points(n, seed));
    const TriangleSoup soup =
        placed(hull.soup, size, random.orientation(), 3 * size * random.unit_vector());
    Story here = story;
    here.seed(seed).given("points", n).given("radius", size, "m");
    const HalfEdgeMesh mesh = require_mesh(soup, here);
    require(expect_counts(here, mesh, n, 3 * n - 6, 2 * n - 4));
    require(expect_sound_links(here, mesh, soup));
    std::vector<int> leaving(mesh.vertices.size(), 0);
    for (const Triangle& triangle : soup.triangles) {
      for (const Index v : triangle) ++leaving[v];
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      int degree = 0;
      for ([[maybe_unused]] const Index e : vertex_edges(mesh, v)) ++degree;
      require(
          here.expect_equal("triangles around vertex " + std::to_string(v), degree, leaving[v]));
    }
  }
}

GRADED_TEST(Lab2, NewellAgreesWithDoubleOnBentPolygons, 2, "L2.5") {
  Random random(251);
  Story story("The plane of a bent, irregular polygon is that of its area vector and its centroid");
  story.seed(random.seed()).likely("each edge counts by the area that it spans with the centroid");
  for (int i = 0; i < 100; ++i) {
    const int n = random.integer(3, 20);
    const Real size = std::pow(Real(10), random.real(-3, 3));
    const Quat turn = random.orientation();
    const Vec3 shift = 2 * size * random.unit_vector();
    std::vector<Vec3> polygon;
    for (int k = 0; k < n; ++k) {
      const Real angle = 2 * pi * (static_cast<Real>(k) + random.real(0, Real(0.9))) / Real(n);
      const Real radius = size * random.real(Real(0.5), 1);
      const Real lift = size * random.real(Real(-0.1), Real(0.1));
      polygon.push_back(turn * Vec3(radius * std::cos(angle), radius * std::sin(angle), lift) +
                        shift);
    }
    const Vec3d area = area_vector(polygon);
    // Three nearly collinear corners determine no plane.
    if (area.norm() < 0.1 * size * size) continue;
    const Plane plane = face_plane(two_sided(polygon), 0);
    Story here = story;
    here.given("corners", n).given("size", size, "m");
    require(here.expect_near("normal", plane.normal, area.normalized().cast<Real>(), 1e-5));
    require(here.expect_near("offset over the size", plane.offset / size,
                             area.normalized().dot(centroid(polygon)) / size, 4e-5));
  }
}

}  // namespace
}  // namespace cs550::test
