// What a user does with a running scene: pull, pick and throw bodies, and read their numbers.
#include "pages/world/world_page.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace cs550::test {
namespace {

using namespace pages;

/// A scene file of bodies, as JSON. It is removed at the end.
class SceneFile {
 public:
  explicit SceneFile(const std::string& members)
      : path_(std::filesystem::temp_directory_path() /
              ("cs550-page-" + std::to_string(getpid()) + ".json")) {
    std::ofstream(path_) << R"({"schema": 1, )" << members << "}";
  }
  ~SceneFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// The value of a fact on the panel.
std::string panel_fact(const WorldPage& page, const std::string& name) {
  for (const Fact& fact : page.content().facts) {
    if (fact.name == name) return fact.value;
  }
  return "missing";
}

/// At a corner, a force turns the box more than it moves it.
TEST(WorldPulls, ABodyAtItsCornerComesToRestAtTheMouse) {
  WorldPage page("free_spin", Isolation::Here);
  page.refresh();
  const Vec3 corner(Real(0.2), Real(0.5), 1);
  const Vec3 grabbed = page.frame().bodies[0].pose.to_world(corner);
  const Vec3 target = grabbed + Vec3(Real(0.3), Real(0.1), Real(0.2));
  page.grab({0, grabbed});
  page.drag_to(target);
  page.take_steps(120);
  const RigidBody& body = page.frame().bodies[0];
  EXPECT_LT((body.pose.to_world(corner) - target).norm(), 0.15);
  EXPECT_LT(body.angular_velocity.norm(), 20);
}

/// The walls of the pit are translucent where they would hide the boxes.
TEST(WorldPicks, BodiesBehindATranslucentWall) {
  WorldPage page("box_pile", Isolation::Here);
  page.refresh();
  const Focus& focus = page.content().focus;
  const Vec3 eye = fitted(page.first_view(), focus.center, focus.radius).eye();
  int rays = 0;
  int dynamic = 0;
  for (const RigidBody& body : page.frame().bodies) {
    if (body.kind != BodyKind::Dynamic) continue;
    ++rays;
    const auto hit = page.pick(eye, (body.pose.position - eye).normalized());
    dynamic += hit && page.frame().bodies[hit->body].kind == BodyKind::Dynamic ? 1 : 0;
  }
  EXPECT_GT(rays, 50);
  EXPECT_GT(dynamic, 0.9 * rays);
}

TEST(WorldFocus, StaysWhenABodyFliesAway) {
  WorldPage page("bounce", Isolation::Here);
  page.refresh();
  const Focus first = page.content().focus;
  const Vec3 above = first.center + Vec3(0, 0, 2 * first.radius);
  page.throw_box(above, Vec3(1, 0, 1));
  const Real side = page.frame().bounds.back().extent().x();
  page.take_steps(600);
  page.refresh();
  EXPECT_LT(page.content().focus.radius, 3 * first.radius);
  page.throw_box(above, Vec3(1, 0, 1));
  EXPECT_NEAR(page.frame().bounds.back().extent().x(), side, 1e-3 * side);
}

/// At 1,000 km a float is exact to 6 cm.
TEST(WorldFocus, IsTheSameInEachStepWhereFloatDoesNotResolveABody) {
  const SceneFile scene(R"("world": {"gravity": [0, 0, 0]}, "bodies": [
    {"shape": {"kind": "box", "half_extents": [0.01, 0.01, 0.01]}, "position": [1e6, 0, 1]}])");
  WorldPage page(scene.path(), Isolation::Here);
  page.take_steps(1);
  page.refresh();
  ASSERT_EQ(page.content().problem, "");
  const Focus first = page.content().focus;
  EXPECT_NEAR(first.center.x(), 1e6, 1);
  page.take_steps(49);
  page.refresh();
  EXPECT_EQ(page.content().focus.radius, first.radius);
}

TEST(WorldNumbers, AreThoseOfTheMomentaBeforeTheFirstStep) {
  WorldPage page("collisions", Isolation::Here);
  page.refresh();
  page.select(Index{0});
  page.refresh();
  EXPECT_EQ(panel_fact(page, "v").substr(0, 5), "(2.00");
  EXPECT_EQ(page.frame().step, 0);
  page.throw_box(Vec3(0, 0, 5), Vec3(0, 0, 1));
  EXPECT_NEAR(page.frame().bodies.back().linear_velocity.z(), 20, 1e-3);
  EXPECT_NEAR(page.frame().bodies.back().angular_velocity.z(), 3, 1e-3);
}

/// A box that looks large where bodies are 200 km apart would be too heavy for a world. So far away, two points on the
/// ray from the eye may be the same in float.
TEST(WorldThrow, WorksInALargeScene) {
  const SceneFile scene(R"("bodies": [
    {"shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}, "position": [-1e5, 0, 1]},
    {"shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}, "position": [1e5, 0, 1]}])");
  WorldPage page(scene.path(), Isolation::Here);
  page.refresh();
  page.throw_box(Vec3(0, Real(3e7), 0), Vec3(Real(0.6), Real(-0.8), 0));
  page.take_steps(1);
  page.refresh();
  EXPECT_EQ(page.content().problem, "");
  ASSERT_EQ(page.frame().bodies.size(), 3U);
  EXPECT_NEAR(page.frame().bodies.back().linear_velocity.x(), 12, 1e-3);
}

/// A scene may have what no slider reaches.
TEST(WorldSettingsOf, AnySceneCanBeSetAgain) {
  const SceneFile scene(R"("world": {"gravity": [0, 0, -981], "substeps": 60, "contact_hertz": 800,
    "restitution_iterations": 0, "relax_iterations": 70}, "bodies": [
    {"shape": {"kind": "box", "half_extents": [1, 1, 1]}}])");
  WorldPage page(scene.path(), Isolation::Here);
  page.refresh();
  ASSERT_EQ(page.content().problem, "");
  ControlLister lister;
  page.describe(lister);
  EXPECT_NE(lister.text().find("substeps=60 "), std::string::npos);
  std::istringstream lines(lister.text());
  for (std::string line; std::getline(lines, line);) {
    ControlSetter setter(line.substr(0, line.find(' ')));
    EXPECT_NO_THROW(page.describe(setter)) << line;
  }
  EXPECT_EQ(page.settings().substeps, 60);
  EXPECT_EQ(page.settings().gravity.z(), -981);
}

}  // namespace
}  // namespace cs550::test
