// L2.1: defects of the triangles themselves, and the elements that are reported.
#include <cs550/graded_test.hpp>
#include <limits>

#include "cs550/not_implemented.hpp"
#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

/// The issue that L2.1 finds. Later steps may be unwritten.
MeshIssue first_issue_of_triangles(const TriangleSoup& soup) {
  try {
    return issue_of(soup);
  } catch (const NotImplemented& later) {
    if (later.step() == "L2.1") throw;
    return {};
  }
}

TriangleSoup unit_box() { return cut_from_corners(box(Vec3::Ones())); }

/// Two faults at once: the check that comes first reports its own, wherever in the lists it is.
void expect_checks_in_order() {
  Story story("Each check is complete before the next one begins");

  TriangleSoup twice = unit_box();
  twice.triangles[3] = {4, 6, 4};
  twice.triangles[7][1] = 8;
  Story indices = story;
  indices.given("a box of twelve triangles, its vertices 0 to 7")
      .given("triangle 3", "4, 6, 4")
      .given("an index in triangle 7", 8)
      .likely(
          "the indices of all triangles are checked before the first area, in a loop of their own");
  const MeshIssue missing = issue_of(twice);
  expect_error(indices, missing, MeshError::IndexOutOfRange);
  indices.expect_equal("the triangle", missing.triangle, 7);

  TriangleSoup unused = unit_box();
  unused.vertices.push_back(Vec3(0, std::numeric_limits<Real>::quiet_NaN(), 0));
  Story coordinates = story;
  coordinates
      .given("a box whose triangles use vertices 0 to 7, and a vertex 8 that none of them uses")
      .given("y of vertex 8", unused.vertices[8].y())
      .likely("the coordinates of all vertices are checked, also of one that no triangle uses");
  const MeshIssue infinite = issue_of(unused);
  expect_error(coordinates, infinite, MeshError::NonFiniteVertex);
  coordinates.expect_equal("the vertex", infinite.vertex, 8);

  TriangleSoup both = unit_box();
  both.vertices[5].z() = std::numeric_limits<Real>::infinity();
  both.triangles[7][1] = 8;
  Story first = story;
  first.given("a box of twelve triangles, its vertices 0 to 7")
      .given("z of vertex 5", both.vertices[5].z())
      .given("an index in triangle 7", 8)
      .likely("the coordinates of all vertices are checked before the first index");
  const MeshIssue of_vertex = issue_of(both);
  expect_error(first, of_vertex, MeshError::NonFiniteVertex);
  first.expect_equal("the vertex", of_vertex.vertex, 5);

  TriangleSoup open = unit_box();
  open.triangles.pop_back();
  open.vertices.push_back(Vec3::Zero());
  Story triangles_first = story;
  triangles_first.given("a box without its last triangle, and a vertex 8 that no triangle uses")
      .likely("the triangles and their vertices are checked before the first edge");
  const MeshIssue isolated = issue_of(open);
  expect_error(triangles_first, isolated, MeshError::IsolatedVertex);
  triangles_first.expect_equal("the vertex", isolated.vertex, 8);

  TriangleSoup duplicate = unit_box();
  const auto [a, b, c] = duplicate.triangles[1];
  duplicate.triangles.push_back({b, c, a});
  story.given("a box of twelve triangles, its vertices 0 to 7")
      .given("triangle 12 is triangle 1, begun at another corner");

  TriangleSoup flat = duplicate;
  flat.triangles.push_back({4, 6, 4});
  Story areas = story;
  areas.given("triangle 13", "4, 6, 4")
      .likely("the areas of all triangles are checked before the first duplicate");
  const MeshIssue degenerate = issue_of(flat);
  expect_error(areas, degenerate, MeshError::DegenerateTriangle);
  areas.expect_equal("the triangle", degenerate.triangle, 13);

  duplicate.vertices.push_back(Vec3::Zero());
  story.given("a vertex 8 that no triangle uses")
      .likely("all triangles are checked for duplicates before a vertex without a triangle counts");
  expect_error(story, issue_of(duplicate), MeshError::DuplicateTriangle);
}

GRADED_TEST(Lab2, MissingAndInfiniteVerticesAreNamed, 2, "L2.1") {
  Story story("Triangles that cannot be used are refused, and the message says which they are");
  story.given("a box of twelve triangles, with one fault")
      .likely("the order of the checks: what a later check reads must have been checked before");

  Story empty = story;
  empty.given("no triangles at all");
  expect_error(empty, issue_of({unit_box().vertices, {}}), MeshError::NoTriangles);

  for (const Real bad :
       {std::numeric_limits<Real>::quiet_NaN(), -std::numeric_limits<Real>::infinity()}) {
    TriangleSoup soup = unit_box();
    soup.vertices[5].y() = bad;
    Story here = story;
    here.given("y of vertex 5", bad).likely("NaN compares false with everything: use isfinite");
    const MeshIssue issue = issue_of(soup);
    expect_error(here, issue, MeshError::NonFiniteVertex);
    here.expect_equal("the vertex", issue.vertex, 5);
  }

  for (const Index missing : {-1, 8}) {
    TriangleSoup soup = unit_box();
    soup.triangles[7][1] = missing;
    Story here = story;
    here.given("vertices", "0 to 7")
        .given("an index in triangle 7", missing)
        .likely("an index must be at least 0 and less than the number of vertices");
    const MeshIssue issue = issue_of(soup);
    expect_error(here, issue, MeshError::IndexOutOfRange);
    here.expect_equal("the triangle", issue.triangle, 7);
    here.expect_equal("the vertex", issue.vertex, missing);
  }
  expect_checks_in_order();
}

GRADED_TEST(Lab2, DegenerateTrianglesAreTheSameAtEveryScale, 2, "L2.1") {
  Story story(
      "A triangle has no area when twice its area is at most 1e-7 of its longest edge squared");
  story.likely("an area in m² cannot be compared with a fixed number: divide by an edge squared")
      .likely("the longest of the three edges counts, whichever corner comes first")
      .likely("the cross product of two edges is twice the area: do not halve it");

  TriangleSoup twice = unit_box();
  twice.triangles[3] = {4, 6, 4};
  Story repeated = story;
  repeated.given("triangle 3", "4, 6, 4");
  expect_error(repeated, issue_of(twice), MeshError::DegenerateTriangle);
  repeated.expect_equal("the triangle", issue_of(twice).triangle, 3);

  const TriangleSoup point{std::vector(4, Vec3(0, 0, 0)),
                           {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  Story coincident = story;
  coincident.given("a tetrahedron with all four vertices at the origin")
      .likely("the limit itself counts: if all corners coincide both sides are 0");
  expect_error(coincident, issue_of(point), MeshError::DegenerateTriangle);
  coincident.expect_equal("the triangle", issue_of(point).triangle, 0);

  // A tetrahedron with an edge of length s. A corner of triangle 0 is at distance h from that edge.
  const auto needle = [](Real size, Real height, std::size_t first_corner) {
    TriangleSoup soup{{{0, 0, 0}, {size, 0, 0}, {size / 2, height, 0}, {size / 2, 0, size}},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    Triangle& triangle = soup.triangles[0];
    std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(first_corner),
                triangle.end());
    return soup;
  };
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    for (const std::size_t first_corner : {0u, 1u, 2u}) {
      Story here = story;
      here.given("longest edge", size, "m").given("first corner", first_corner);
      Story flat = here;
      flat.given("height over it", Real(0.75e-7) * size, "m");
      const MeshIssue issue = issue_of(needle(size, Real(0.75e-7) * size, first_corner));
      require(expect_error(flat, issue, MeshError::DegenerateTriangle));
      flat.expect_equal("the triangle", issue.triangle, 0);

      Story thin = here;
      thin.given("height over it", Real(1.5e-7) * size, "m");
      const TriangleSoup soup = needle(size, Real(1.5e-7) * size, first_corner);
      require(expect_error(thin, first_issue_of_triangles(soup), MeshError::None));
    }
  }
}

GRADED_TEST(Lab2, DuplicatesAndIsolatedVerticesAreNamed, 2, "L2.1") {
  Story story("Two triangles with the same vertices, and a vertex without a triangle, are refused");

  for (const bool is_reversed : {false, true}) {
    TriangleSoup soup = unit_box();
    const auto [a, b, c] = soup.triangles[1];
    soup.triangles.push_back(is_reversed ? Triangle{c, b, a} : Triangle{b, c, a});
    Story here = story;
    here.given("a box of twelve triangles")
        .given(is_reversed ? "triangle 12 is triangle 1 reversed"
                           : "triangle 12 is triangle 1, begun at another corner")
        .likely("compare the three vertices in sorted order: where a triangle begins is no matter");
    const MeshIssue issue = issue_of(soup);
    require(expect_error(here, issue, MeshError::DuplicateTriangle));
    here.expect_equal("the one triangle", std::min(issue.triangle, issue.other_triangle), 1);
    here.expect_equal("the other triangle", std::max(issue.triangle, issue.other_triangle), 12);
  }

  TriangleSoup soup = unit_box();
  soup.vertices.insert(soup.vertices.begin() + 2, Vec3::Zero());
  for (Triangle& triangle : soup.triangles) {
    for (Index& v : triangle) v += v >= 2 ? 1 : 0;
  }
  story.given("a box of nine vertices, of which the triangles do not use number 2");
  const MeshIssue issue = issue_of(soup);
  expect_error(story, issue, MeshError::IsolatedVertex);
  story.expect_equal("the vertex", issue.vertex, 2);
}

}  // namespace
}  // namespace cs550::test
