#pragma once
/// @file mesh_checks.hpp
/// Checks of a mesh for the tests of lab 2, without the functions under test.

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cs550/mesh_validation.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"
#include "lab2_half_edge_mesh/pictures.hpp"

namespace cs550::test {

using Vec3d = Eigen::Vector3d;

/// The mesh of a valid list of triangles. If there is none, the test ends.
inline HalfEdgeMesh require_mesh(const TriangleSoup& soup, const Story& story) {
  Story here = story;
  here.likely("build_half_edge_mesh() refuses triangles in which nothing is wrong");
  MeshBuild build = build_half_edge_mesh(soup.vertices, soup.triangles);
  require(here.expect_equal("what build_half_edge_mesh() reports", describe(build.issue),
                            describe(MeshIssue{})));
  require(here.expect_equal("faces, one for each triangle", build.mesh.faces.size(),
                            soup.triangles.size()));
  return std::move(build.mesh);
}

/// The fault of a list of triangles. If there is one, there must be no mesh.
inline MeshIssue issue_of(const TriangleSoup& soup) {
  const auto [mesh, issue] = build_half_edge_mesh(soup.vertices, soup.triangles);
  if (!issue) return issue;
  Story story("Triangles in which something is wrong give no mesh");
  story.given("what build_half_edge_mesh() reports: " + describe(issue))
      .likely(
          "the mesh beside an issue is empty: return a new one, not what has been built so far");
  require(story.expect_equal("vertices", mesh.vertices.size(), std::size_t(0)));
  require(story.expect_equal("half-edges", mesh.edges.size(), std::size_t(0)));
  require(story.expect_equal("faces", mesh.faces.size(), std::size_t(0)));
  require(story.expect_equal("entries of vertex_edge", mesh.vertex_edge.size(), std::size_t(0)));
  return issue;
}

/// The name of an error in C++.
inline std::string name_of(MeshError error) {
  constexpr const char* names[] = {"None",
                                   "NoTriangles",
                                   "NonFiniteVertex",
                                   "IndexOutOfRange",
                                   "DegenerateTriangle",
                                   "DuplicateTriangle",
                                   "IsolatedVertex",
                                   "OpenEdge",
                                   "NonManifoldEdge",
                                   "InconsistentWinding",
                                   "InsideOut"};
  const auto number = static_cast<unsigned>(error);
  return number < std::size(names) ? names[number] : "MeshError " + std::to_string(number);
}

/// Whether an issue is of a kind. The report shows its elements.
inline bool expect_error(Story& story, const MeshIssue& issue, MeshError expected) {
  const std::string got = name_of(issue.error) + " (" + describe(issue) + ")";
  return story.expect_equal("the fault", issue.error == expected ? name_of(expected) : got,
                            name_of(expected));
}

/// Whether the given validate() finds no defect.
inline bool expect_valid(Story& story, const HalfEdgeMesh& mesh, Real tolerance = Real(1e-4)) {
  const std::optional<MeshDefect> defect = validate(mesh, tolerance);
  if (defect) story.picture([&] { return defect_picture(mesh, *defect); });
  return story.expect_equal("what validate() says", defect ? defect->sentence : "sound",
                            std::string("sound"));
}

/// Whether validate() finds no defect in the links. It checks the planes of the triangles: those of
/// the mesh have tests of their own.
inline bool expect_sound_links(Story& story, HalfEdgeMesh mesh, const TriangleSoup& soup) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    const Vec3d corner = soup.vertices[a].cast<double>();
    const Vec3d normal = (soup.vertices[b].cast<double>() - corner)
                             .cross(soup.vertices[c].cast<double>() - corner)
                             .normalized();
    mesh.faces[f].plane = {normal.cast<Real>(), static_cast<Real>(normal.dot(corner))};
  }
  return expect_valid(story, mesh);
}

/// Ends the test unless L2.6 links the loop of two merged triangles. Otherwise further merges could
/// follow wrong links endlessly.
inline void require_linked_merge() {
  Story story("Two triangles that become one face are linked into one loop");
  story.given("prism over a triangle, its sides of two triangles each")
      .likely("prev has to follow as well as next, and both halves of a removed edge are marked");
  const HalfEdgeMesh built = require_mesh(prism_soup(3, 1, 1), story);
  require(expect_valid(story, merge_coplanar_faces(built)));
}

/// Vertices, edges and faces.
inline bool expect_counts(Story& story, const HalfEdgeMesh& mesh, Index vertices, Index edges,
                          Index faces) {
  const bool has_faces = story.expect_equal("faces", mesh.face_count(), faces);
  const bool has_vertices = story.expect_equal("vertices", mesh.vertex_count(), vertices);
  return story.expect_equal("half-edges, two for each edge", mesh.edge_count(), 2 * edges) &&
         has_faces && has_vertices;
}

/// The vertices of a face, counter-clockwise. Stops after as many vertices as the mesh has
/// half-edges, so that a loop that never closes fails the test and does not hang it.
inline std::vector<Index> loop_of(const HalfEdgeMesh& mesh, Index face) {
  std::vector<Index> loop;
  const Index first = mesh.face(face).edge;
  Index e = first;
  do {
    loop.push_back(mesh.origin(e));
    e = mesh.edge(e).next;
  } while (e != first && loop.size() <= mesh.edges.size());
  return loop;
}

using Point = std::array<Real, 3>;

/// Every face as a ring of its corners' coordinates: the shape of a mesh without its numbering.
inline std::multiset<std::vector<Point>> faces_as_seen(const HalfEdgeMesh& mesh) {
  std::multiset<std::vector<Point>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Point> ring;
    for (const Index v : loop_of(mesh, f)) {
      const Vec3& vertex = mesh.vertex(v);
      ring.push_back({vertex.x(), vertex.y(), vertex.z()});
    }
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    faces.insert(ring);
  }
  return faces;
}

inline std::string show(const std::vector<Point>& ring) {
  std::string text = "a face with the corners";
  for (const Point& corner : ring) text += ' ' + Story::show(Vec3(corner[0], corner[1], corner[2]));
  return text;
}

/// Checks that two meshes have the same faces, whatever their numbers. A failure shows the first face that
/// only one of them has.
inline bool expect_same_faces(const Story& story, const HalfEdgeMesh& got,
                              const HalfEdgeMesh& expected, SourceLine at = {}) {
  const auto faces_got = faces_as_seen(got);
  const auto faces_expected = faces_as_seen(expected);
  const auto [one, other] = std::mismatch(faces_got.begin(), faces_got.end(),
                                          faces_expected.begin(), faces_expected.end());
  const bool is_same = one == faces_got.end() && other == faces_expected.end();
  Story here = story;
  return here.expect("the faces, in the order of their corners", is_same,
                     one == faces_got.end() ? "no further face" : show(*one),
                     other == faces_expected.end() ? "no further face" : show(*other), at);
}

/// The area vector of a polygon (m²), half the sum of p_i × p_(i+1): its direction is the normal,
/// its length the area.
inline Vec3d area_vector(const std::vector<Vec3>& polygon) {
  const Vec3d base = polygon.front().cast<double>();
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d a = polygon[i].cast<double>() - base;
    const Vec3d b = polygon[(i + 1) % polygon.size()].cast<double>() - base;
    sum += 0.5 * a.cross(b);
  }
  return sum;
}

inline Vec3d centroid(const std::vector<Vec3>& points) {
  Vec3d sum = Vec3d::Zero();
  for (const Vec3& point : points) sum += point.cast<double>();
  return sum / static_cast<double>(points.size());
}

inline std::vector<Vec3> corners(const HalfEdgeMesh& mesh, Index face) {
  std::vector<Vec3> points;
  for (const Index v : loop_of(mesh, face)) points.push_back(mesh.vertex(v));
  return points;
}

/// The largest distance of a vertex from the plane of its face (m), in double.
inline double worst_distance_from_planes(const HalfEdgeMesh& mesh) {
  double worst = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const std::vector<Vec3> points = corners(mesh, f);
    const Vec3d normal = area_vector(points).normalized();
    const Vec3d middle = centroid(points);
    for (const Vec3& point : points) {
      worst = std::max(worst, std::abs(normal.dot(point.cast<double>() - middle)));
    }
  }
  return worst;
}

/// The volume (m³) by the divergence theorem: a third of the sum of centroid·area over the faces.
inline double volume(const HalfEdgeMesh& mesh) {
  const Vec3d base = mesh.vertex(0).cast<double>();
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const std::vector<Vec3> points = corners(mesh, f);
    sum += area_vector(points).dot(points.front().cast<double>() - base) / 3;
  }
  return sum;
}

/// A polygon as a mesh of two faces, front and back, sufficient to compute a plane.
inline HalfEdgeMesh two_sided(const std::vector<Vec3>& polygon) {
  const Index n = static_cast<Index>(polygon.size());
  HalfEdgeMesh mesh;
  mesh.vertices = polygon;
  for (Index i = 0; i < n; ++i) {
    const Index after = (i + 1) % n;
    const Index before = (i + n - 1) % n;
    mesh.vertex_edge.push_back(2 * i);
    mesh.edges.push_back({after, 2 * after, 2 * before, 2 * i + 1, 0});
    mesh.edges.push_back({i, 2 * before + 1, 2 * after + 1, 2 * i, 1});
  }
  mesh.faces = {{0, {}}, {1, {}}};
  return mesh;
}

}  // namespace cs550::test
