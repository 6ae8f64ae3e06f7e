// Values of each lab become the correct elements of a drawing, even if the values are wrong.

#include <gtest/gtest.h>

#include <algorithm>

#include "drawing/climb_drawing.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/impulse_drawing.hpp"
#include "drawing/manifold_drawing.hpp"
#include "drawing/mesh_drawing.hpp"
#include "drawing/svg.hpp"
#include "drawing/trajectory_drawing.hpp"
#include "helpers/fixtures.hpp"
#include "xml.hpp"

namespace cs550::drawing {
namespace {

using test::fixture_mesh;
using test::fixture_shape;

template <class Element>
int count_role(const std::vector<Element>& elements, Role role) {
  int result = 0;
  for (const Element& element : elements) result += element.role == role ? 1 : 0;
  return result;
}

ClipPolygon polygon_of(const std::vector<Vec3>& points) {
  ClipPolygon polygon;
  for (const Vec3& point : points) polygon.push_back({point, {}, {}});
  return polygon;
}

TEST(MeshDrawing, HasEveryFaceAndEveryEdgeOnce) {
  const HalfEdgeMesh& mesh = fixture_mesh("dodecahedron");
  const Drawing drawing = draw_mesh(mesh);
  EXPECT_EQ(drawing.polygons.size(), 12U);
  EXPECT_EQ(drawing.lines.size(), 30U);
  for (const Polygon& face : drawing.polygons) EXPECT_EQ(face.corners.size(), 5U);
}

TEST(MeshDrawing, AHalfEdgeComesWithItsFourNeighbours) {
  const Drawing drawing = draw_half_edge(fixture_mesh("prism6"), 4);
  int arrows = 0;
  for (const Line& line : drawing.lines) arrows += line.stroke.arrow ? 1 : 0;
  EXPECT_EQ(arrows, 4);  // itself, next, prev, twin
  EXPECT_EQ(count_role(drawing.polygons, Role::Reference), 1);
  EXPECT_TRUE(drawing.notes.empty());
}

TEST(MeshDrawing, SurvivesLinksThatPointNowhere) {
  HalfEdgeMesh mesh = fixture_mesh("cube");
  mesh.edges[0] = {99, -7, 1234, -1, 55};
  mesh.edges[5].next = 5;
  mesh.faces[2].edge = -4;
  mesh.vertices[3].x() = NAN;
  const Drawing drawing = draw_half_edge(mesh, 0);
  EXPECT_EQ(drawing.notes.size(), 6U);  // vertex, face, next, prev, twin, and its own ends
  const Index faces[] = {-1, 2, 99};
  const Index edges[] = {0, 5, 1000};
  const Index vertices[] = {-1, 3, 8};
  const Drawing fault = draw_mesh_fault(mesh, "It is broken.", faces, edges, vertices);
  EXPECT_EQ(test::xml_fault(write_svg(fault)), "");
}

TEST(MeshDrawing, LoopsThatNeverCloseDoNotMakeItEndless) {
  HalfEdgeMesh mesh = fixture_mesh("dodecahedron");
  for (HalfEdge& edge : mesh.edges) edge.next = 2;
  for (Face& face : mesh.faces) face.edge = 0;
  std::size_t corners = 0;
  for (const Polygon& face : draw_mesh(mesh).polygons) corners += face.corners.size();
  EXPECT_LE(corners, 5 * mesh.edges.size());
}

TEST(MeshDrawing, LightsTheTriangleAndTheEdgeOfAnIssue) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {7, 8, 9}};
  MeshIssue issue;
  issue.error = MeshError::InconsistentWinding;
  issue.triangle = 1;
  issue.edge = {0, 1};
  const Drawing drawing = draw_triangles(vertices, triangles, issue);
  EXPECT_EQ(drawing.polygons.size(), 2U);  // the third names vertices that do not exist
  EXPECT_EQ(count_role(drawing.polygons, Role::Warning), 1);
}

TEST(ClimbDrawing, HasAnArrowForEachStepAndALabelForEachVertex) {
  const Index path[] = {0, 1, 3};
  const Drawing drawing = draw_climb(fixture_mesh("cube"), {1, 1, 1}, path);
  int steps = 0;
  for (const Line& line : drawing.lines) steps += line.stroke.role == Role::Highlight ? 1 : 0;
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(drawing.labels.size(), 3U + 1U);  // and the direction
}

TEST(ClimbDrawing, TheArrowEndsAtItsTip) {
  const HalfEdgeMesh& mesh = fixture_mesh("cube");
  const Index path[] = {0};
  for (const Vec3& direction : {Vec3(1, 2, -3), Vec3(0, 0, 0), Vec3(0, 0, Real(1e-3))}) {
    const ClimbArrow arrow = climb_arrow(mesh, direction);
    const Drawing drawing = draw_climb(mesh, direction, path);
    const auto drawn = std::find_if(
        drawing.lines.begin(), drawing.lines.end(),
        [](const Line& line) { return line.stroke.role == Role::Axis && line.stroke.arrow; });
    ASSERT_NE(drawn, drawing.lines.end());
    EXPECT_LT((drawn->to - arrow.tip).norm(), 1e-5);
    EXPECT_LT((arrow.tip - arrow.middle).cross(direction).norm(), 1e-4);
  }
}

TEST(ClimbDrawing, ThePlaneSaysWhetherVerticesAreBeyondIt) {
  const HalfEdgeMesh& mesh = fixture_mesh("cube");
  const Vec3 direction(1, Real(0.5), Real(0.25));
  Index end = 0;
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    if (mesh.vertex(v).dot(direction) > mesh.vertex(end).dot(direction)) end = v;
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index path[] = {v};
    const Drawing drawing = draw_climb(mesh, direction, path);
    EXPECT_EQ(drawing.legend.back().text == "no vertex beyond this plane", v == end) << v;
  }
}

TEST(ClimbDrawing, NotesAVertexThatDoesNotExist) {
  const Index path[] = {0, 42, -1};
  EXPECT_EQ(draw_climb(fixture_mesh("cube"), {1, 0, 0}, path).notes.size(), 2U);
}

TEST(ClipDrawing, DrawsEveryCornerOfWhatIsLeft) {
  const ClipPolygon before = polygon_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const ClipPolygon after = polygon_of({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  const Plane plane = {{1, 0, 0}, 1};
  const Drawing drawing = draw_clip(before, plane, after, Role::Got);
  ASSERT_EQ(count_role(drawing.points, Role::Got), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(drawing.points[i].position, after[i].point);
  // The plane is drawn where it is.
  for (const Line& line : drawing.lines) {
    if (line.stroke.role != Role::Axis || line.stroke.arrow) continue;
    EXPECT_NEAR(plane.distance(line.from), 0, 1e-6);
    EXPECT_NEAR(plane.distance(line.to), 0, 1e-6);
  }
}

TEST(ClipDrawing, StepsStopAtTheLastPolygon) {
  const ClipPolygon polygon = polygon_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}});
  const std::vector<Vec3> reference = corners(polygon);
  const Plane planes[] = {{{1, 0, 0}, 3}};
  const ClipPolygon polygons[] = {polygon, polygon};
  EXPECT_EQ(draw_clipping(reference, planes, polygons, 0).title, "Incident face");
  EXPECT_EQ(draw_clipping(reference, planes, polygons, 9).title, "After plane 1");
  EXPECT_EQ(draw_clipping(reference, planes, {}, 1).points.size(), 0U);
}

TEST(ManifoldDrawing, EachPointStandsBetweenItsAnchors) {
  const ShapePtr cube = fixture_shape("cube");
  Manifold manifold;
  manifold.normal = Vec3::UnitZ();
  manifold.tangent = Vec3::UnitX();
  for (const Real x : {Real(-0.5), Real(0.5)}) {
    ContactPoint point;
    point.anchor_a = {x, 0, Real(0.5)};
    point.anchor_b = {x, 0, Real(-0.5)};
    point.separation = Real(-0.1);
    manifold.points.push_back(point);
  }
  const Pose above = {{0, 0, Real(0.9)}, Quat::Identity()};
  const Drawing drawing = draw_contact({cube.get(), {}}, {cube.get(), above}, manifold);
  EXPECT_EQ(count_role(drawing.points, Role::Highlight), 2);
  for (const Point& point : drawing.points) {
    if (point.role != Role::Highlight) continue;
    EXPECT_NEAR(point.position.z(), 0.45, 1e-6);
  }
}

TEST(ManifoldDrawing, NamesTheFeaturesThatMeet) {
  using Kind = FeatureId::Kind;
  EXPECT_EQ(feature_text(FeatureId(Kind::VertexOnFaceA, 2, 3)), "vertex 3 of B on face 2 of A");
  EXPECT_EQ(feature_text(FeatureId(Kind::VertexOnFaceB, 2, 3)), "vertex 2 of A on face 3 of B");
  EXPECT_EQ(feature_text(FeatureId(Kind::Edges, 7, 9)), "edge 7 of A and edge 9 of B");
  EXPECT_EQ(feature_text(FeatureId()), "nothing");
}

TEST(ManifoldDrawing, SurvivesNumbersThatAreNone) {
  ContactPoint point;
  point.anchor_a = Vec3::Constant(NAN);
  const std::vector<ContactPoint> points(5, point);
  const Drawing drawing = draw_reduction(points, points, Vec3::UnitZ());
  EXPECT_EQ(test::xml_fault(write_svg(drawing)), "");
}

TEST(TrajectoryDrawing, ThePolhodeOfAnExactRotationLiesOnTheEllipsoid) {
  const Vec3 inertia = {2, 3, 4};
  const Vec3 w = {1, 2, 3};
  const Vec3 steps[] = {w, w};
  const Drawing drawing = draw_polhode(inertia, steps, {}, "exact");
  const Real energy = Real(0.5) * w.dot(inertia.cwiseProduct(w));
  for (const Polygon& patch : drawing.polygons) {
    for (const Vec3& corner : patch.corners) {
      EXPECT_NEAR(0.5 * corner.dot(inertia.cwiseProduct(corner)), energy, 1e-4 * energy);
    }
  }
}

TEST(TrajectoryDrawing, ATrailHasAPieceForEachStep) {
  const std::vector<Pose> poses(10);
  EXPECT_EQ(draw_trail(poses, Vec3::UnitX(), {}, "trail").lines.size(), 9U);
}

TEST(ImpulseDrawing, ArrowsAreAsLongAsTheirImpulses) {
  ContactConstraint constraint;
  constraint.body_a = 0;
  constraint.body_b = 1;
  constraint.n = Vec3::UnitZ();
  constraint.u = Vec3::UnitX();
  constraint.r_b = {0, 0, -1};
  constraint.normal_impulse = 5;
  const std::vector<ContactConstraint> constraints = {constraint};
  const std::vector<Vec3> centers = {{0, 0, 0}, {7, 0, 1}};
  EXPECT_EQ(impulse_scale(constraints, 2), Real(0.4));
  const Drawing drawing = draw_impulses(constraints, centers, impulse_scale(constraints, 2));
  ASSERT_EQ(drawing.lines.size(), 1U);
  EXPECT_EQ(drawing.lines[0].from, Vec3(7, 0, 0));
  EXPECT_EQ(drawing.lines[0].to, Vec3(7, 0, 2));
  EXPECT_EQ(draw_impulses(constraints, {centers.data(), 1}, 1).notes.size(), 1U);
}

TEST(ImpulseDrawing, TheDiskHasTheRadiusOfTheLimit) {
  const DiskImpulse impulses[] = {{{3, 4}, Role::Got, "got"}};
  const Drawing drawing = draw_friction_disk(2, impulses, {1, 0});
  ASSERT_EQ(drawing.polygons.size(), 1U);
  for (const Vec3& corner : drawing.polygons[0].corners) EXPECT_NEAR(corner.norm(), 2, 1e-5);
}

TEST(LabDrawings, SayInWordsWhatTheyShow) {
  const HalfEdgeMesh& mesh = fixture_mesh("cube");
  const ShapePtr cube = fixture_shape("cube");
  const ClipPolygon polygon = polygon_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}});
  const Index path[] = {0, 1};
  const std::vector<Pose> poses(3);
  for (const Drawing& drawing :
       {draw_mesh(mesh), draw_half_edge(mesh, 0), draw_climb(mesh, {1, 0, 0}, path),
        draw_clip(polygon, {}, polygon), draw_contact({cube.get(), {}}, {cube.get(), {}}, {}),
        draw_trail(poses, {}, {}, "trail"), draw_polhode({1, 1, 1}, {}, {}, "none"),
        draw_impulses({}, {}, 1), draw_friction_disk(1, {}, {}),
        draw_reduction({}, {}, {0, 0, 1})}) {
    EXPECT_NE(drawing.title, "");
    EXPECT_NE(drawing.alt_text, "") << drawing.title;
  }
}

}  // namespace
}  // namespace cs550::drawing
