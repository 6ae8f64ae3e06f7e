// L2.2: the edges between triangles, which become twins.
#include <cs550/graded_test.hpp>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

/// Checks that the edge of an issue is a side of a triangle.
bool expect_side(Story& story, const std::string& what, const Triangle& triangle,
                 const MeshIssue& issue) {
  const auto has = [&](Index v) { return std::count(triangle.begin(), triangle.end(), v) == 1; };
  return story.expect(what, has(issue.edge[0]) && has(issue.edge[1]),
                      "the edge between vertices " + Story::show(issue.edge),
                      "two of its corners " + Story::show(triangle));
}

/// Checks that the edge of an issue is a side of both of its triangles.
void require_shared_edge(Story& story, const TriangleSoup& soup, const MeshIssue& issue) {
  const Index count = static_cast<Index>(soup.triangles.size());
  for (const Index t : {issue.triangle, issue.other_triangle}) {
    const bool exists = t >= 0 && t < count;
    require(story.expect("the triangles of the issue", exists, std::to_string(t),
                         "0 to " + std::to_string(count - 1)));
    const Triangle& triangle = soup.triangles[t];
    require(expect_side(story, "the edge of the issue, a side of its triangle " + std::to_string(t),
                        triangle, issue));
  }
  require(story.expect("the two triangles of the issue", issue.triangle != issue.other_triangle,
                       std::to_string(issue.triangle) + " twice", "two different ones"));
}

GRADED_TEST(Lab2, OpenEdgesAreNamed, 2, "L2.2") {
  Story story("An edge with one triangle only is open, wherever the hole is");
  story.likely("every edge needs a second side: what has none left over is open")
      .likely("the number of half-edges must not be taken for granted: three a triangle may be odd")
      .likely("the search goes on behind a run that is not a pair, as behind any other");
  const TriangleSoup whole = cut_from_corners(box(Vec3(1, 2, 3)));
  for (std::size_t removed = 0; removed < whole.triangles.size(); ++removed) {
    TriangleSoup soup = whole;
    const Triangle gone = soup.triangles[removed];
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(removed));
    Story here = story;
    here.given("a box of twelve triangles without triangle " + std::to_string(removed));
    const MeshIssue issue = issue_of(soup);
    const MeshIssue expected{.error = MeshError::OpenEdge, .edge = {gone[0], gone[1]}};
    here.picture(
        [&] { return issue_picture(soup, expected, "an edge at the hole is open", issue); });
    require(expect_error(here, issue, MeshError::OpenEdge));
    expect_side(here, "the edge of the issue, a side of the missing triangle", gone, issue);
    const bool exists =
        issue.triangle >= 0 && issue.triangle < static_cast<Index>(soup.triangles.size());
    require(here.expect("the triangle of the issue", exists, std::to_string(issue.triangle),
                        "0 to " + std::to_string(soup.triangles.size() - 1)));
    expect_side(here, "the edge of the issue, a side of its triangle",
                soup.triangles[issue.triangle], issue);
  }
}

/// Two tetrahedra share an edge: four triangles meet there, and two at every other edge.
void expect_four_triangles_named(Story story) {
  const TriangleSoup soup{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}}};
  story.given("two tetrahedra that share the edge 0–1, which belongs to four triangles")
      .likely("an edge may have more than three triangles: ask for more than two");
  const MeshIssue issue = issue_of(soup);
  if (expect_error(story, issue, MeshError::NonManifoldEdge)) {
    require_shared_edge(story, soup, issue);
  }
}

GRADED_TEST(Lab2, CrowdedAndReversedEdgesAreNamed, 2, "L2.2") {
  Story story("At an edge meet two triangles, which run along it in opposite directions");
  TriangleSoup fins = cut_from_corners(box(Vec3::Ones()));
  fins.vertices.push_back({3, 0, 0});
  fins.triangles.push_back({1, 5, 8});  // a fin at the edge 1–5, open at its other sides
  Story crowded = story;
  crowded.given("a box with a fin at the edge 1–5")
      .likely("all edges are looked at for three triangles before any is looked at for a hole");
  const MeshIssue fin = issue_of(fins);
  crowded.picture([&] {
    return issue_picture(fins, {.error = MeshError::NonManifoldEdge, .edge = {1, 5}},
                         "three triangles meet at the edge 1–5", fin);
  });
  if (expect_error(crowded, fin, MeshError::NonManifoldEdge)) {
    crowded.expect("the edge of the issue",
                   std::minmax({fin.edge[0], fin.edge[1]}) == std::minmax({Index(1), Index(5)}),
                   Story::show(fin.edge), "1, 5");
    require_shared_edge(crowded, fins, fin);
  }
  expect_four_triangles_named(story);

  const TriangleSoup whole = cut_from_corners(dodecahedron());
  for (std::size_t reversed = 0; reversed < whole.triangles.size(); ++reversed) {
    TriangleSoup soup = whole;
    std::swap(soup.triangles[reversed][0], soup.triangles[reversed][1]);
    Story here = story;
    here.given("a dodecahedron of 36 triangles with triangle " + std::to_string(reversed) +
               " reversed")
        .likely(
            "the two sides of an edge must be (a, b) and (b, a): the same pair, in any order, is "
            "not enough");
    const MeshIssue issue = issue_of(soup);
    const MeshIssue expected{.error = MeshError::InconsistentWinding,
                             .triangle = static_cast<Index>(reversed)};
    here.picture([&] { return issue_picture(soup, expected, "this triangle is reversed", issue); });
    require(expect_error(here, issue, MeshError::InconsistentWinding));
    require_shared_edge(here, soup, issue);
    const Index t = static_cast<Index>(reversed);
    here.expect("the two triangles of the issue", issue.triangle == t || issue.other_triangle == t,
                Story::show(std::array{issue.triangle, issue.other_triangle}),
                "one of them " + std::to_string(t));
  }

  // Both faults at once: the header requires that the crowded edge is reported first.
  std::swap(fins.triangles[0][0], fins.triangles[0][1]);
  crowded.given("triangle 0 reversed as well");
  expect_error(crowded, issue_of(fins), MeshError::NonManifoldEdge);
  fins.triangles.pop_back();
  fins.vertices.pop_back();
  fins.triangles.pop_back();
  Story both = story;
  both.given("a box without its last triangle, and triangle 0 reversed")
      .likely("all edges are looked at for their winding before any is looked at for a hole");
  expect_error(both, issue_of(fins), MeshError::InconsistentWinding);
}

std::string as_words(const std::pair<Index, Index>& side) {
  return "from vertex " + std::to_string(side.first) + " to vertex " + std::to_string(side.second);
}

GRADED_TEST(Lab2, TwinsAreNeighboursAndRunOpposite, 2, "L2.2") {
  Story story("Half-edges 2k and 2k + 1 are twins, and each runs where the other came from");
  story.likely("twins get neighbouring places when their sides are sorted by their two vertices");
  for (const TriangleSoup& soup : {cut_from_corners(box(Vec3::Ones())),
                                   cut_from_centres(dodecahedron()), icosphere_soup(2, 1)}) {
    Story here = story;
    here.given("triangles", soup.triangles.size());
    const HalfEdgeMesh mesh = require_mesh(soup, here);
    require(here.expect_equal("half-edges, three for each triangle", mesh.edges.size(),
                              3 * soup.triangles.size()));
    std::set<std::pair<Index, Index>> seen;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      here.given("half-edge", e);
      require(here.expect_equal("its twin", mesh.edge(e).twin, e ^ 1));
      const std::pair side(mesh.origin(e), mesh.edge(e).vertex);
      require(here.expect("the vertices of the half-edge", seen.insert(side).second,
                          as_words(side) + ", as another half-edge", "a pair of its own"));
    }
    for (const Triangle& triangle : soup.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair side(triangle[i], triangle[(i + 1) % 3]);
        require(story.expect("every side of a triangle is a half-edge", seen.count(side) == 1,
                             "no half-edge " + as_words(side), "one"));
      }
    }
  }
}

}  // namespace
}  // namespace cs550::test
