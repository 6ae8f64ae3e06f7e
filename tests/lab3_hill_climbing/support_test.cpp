// L3.3: the support point of a body in the world.
#include <cs550/graded_test.hpp>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

Story with_support_causes(Story story) {
  return story.likely("d_local = Rᵀ·d: from world to body is the inverse rotation")
      .likely("a direction has no place: turn it, but do not move it by the body's position")
      .likely("the point comes back to the world: R·v + x");
}

/// Checks that the vertex is the highest in the world, and that the point is its position there.
void require_world_support(Story here, const PosedShape& body, const Vec3& direction,
                           const SupportPoint& answer) {
  const HalfEdgeMesh& mesh = body.mesh();
  here.given("position", body.pose.position, "m").given("direction", direction);
  here.picture([&] { return support_picture(body, direction, answer); });
  require(here.expect_index("vertex of the answer", answer.vertex, mesh.vertex_count()));
  const Eigen::Matrix3d rotation = body.pose.orientation.cast<double>().toRotationMatrix();
  const Eigen::Vector3d d = direction.cast<double>();
  double greatest = -HUGE_VAL;
  for (const Vec3& v : mesh.vertices) {
    greatest = std::max(greatest, (rotation * v.cast<double>()).dot(d));
  }
  const Eigen::Vector3d arm = rotation * mesh.vertex(answer.vertex).cast<double>();
  require(here.expect_near("height above the body's origin", arm.dot(d), greatest,
                           height_tolerance(mesh, direction), "m"));
  const Eigen::Vector3d point = body.pose.position.cast<double>() + arm;
  // The rounding of a coordinate in the world, and of the rotation.
  const double tolerance = 2e-7 * double{body.pose.position.norm()} + 1e-6 * size_of(mesh);
  require(
      here.expect_near("the point in the world", answer.point, point.cast<Real>(), tolerance, "m"));
}

GRADED_TEST(Lab3, SupportTurnsTheDirection, 5, "L3.3") {
  Random random(36);
  Story story =
      with_support_causes(Story("A turned body is searched along the turned-back direction"));
  story.seed(random.seed()).when("support()");
  for (const std::string name : {"box_1x2x3", "regular_tetrahedron", "prism6", "hull32"}) {
    const ShapePtr shape = fixture_shape(name);
    Story here = story;
    here.given("shape " + name);
    for (int i = 0; i < 40; ++i) {
      const PosedShape body{shape.get(), {Vec3::Zero(), random.orientation()}};
      const Vec3 direction = random.real(Real(0.1), 10) * random.unit_vector();
      require_world_support(here, body, direction, support(body, direction));
    }
  }
}

GRADED_TEST(Lab3, SupportDoesNotMoveTheDirection, 4, "L3.3") {
  Random random(37);
  Story story =
      with_support_causes(Story("Where a body is does not change which vertex is extreme"));
  story.seed(random.seed()).when("support() of a body 1 m to 1000 m from the world's origin");
  const ShapePtr shape = fixture_shape("hull32");
  for (const Real distance : {Real(1), Real(30), Real(1000)}) {
    for (int i = 0; i < 40; ++i) {
      const Vec3 place = distance * random.unit_vector();
      const PosedShape body{shape.get(), {place, random.orientation()}};
      const Vec3 direction = random.unit_vector();
      require_world_support(story, body, direction, support(body, direction));
    }
  }
}

GRADED_TEST(Lab3, SupportStartsWhereItIsTold, 3, "L3.3") {
  Story story("The climb begins at the start that the caller gives: last time's answer, usually");
  story.given("twin_peaks upside down: vertex 6 ends a lower peak, vertex 7 the higher one");
  story.given("direction -z").when("support()");
  story.likely("hand the start on to hill_climb()").likely("climb with d_local, not with d");
  ConvexShape peaks;
  peaks.mesh = fixture_mesh("twin_peaks");
  const PosedShape body{&peaks, {Vec3(5, 0, 0), Quat(0, 1, 0, 0)}};
  const struct {
    Index start;
    Index top;
  } climbs[] = {{6, 6}, {7, 7}, {5, 6}, {3, 7}};
  for (const auto& climb : climbs) {
    Story here = story;
    here.given("start", climb.start);
    const SupportPoint answer = support(body, -Vec3::UnitZ(), climb.start);
    require(here.expect_equal("the climb ends at vertex", answer.vertex, climb.top));
    const Vec3 expected = climb.top == 6 ? Vec3(4, 0, -1) : Vec3(6, 0, -2);
    require(here.expect_near("the point in the world", answer.point, expected, 1e-6, "m"));
  }
}

}  // namespace
}  // namespace cs550::test
