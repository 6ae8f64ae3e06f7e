// Scene files that are correct are read completely.

#include "cs550/scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "engine/scene_text.hpp"
#include "helpers/scoped_environment.hpp"

namespace cs550 {
namespace {

TEST(Scene, ReadsEveryMemberOfABody) {
  const SceneResult result = load_text(with_body(R"({
      "name": "it", "kind": "kinematic", "mass": 12.5, "position": [1, 2, 3],
      "orientation": {"axis": [0, 0, 2], "degrees": 90},
      "linear_velocity": [4, 5, 6], "angular_velocity": [7, 8, 9],
      "friction": 0.25, "restitution": 0.75, "filter": {"category": 2, "mask": 4294967293},)" +
                                                 std::string(shape_member) + "}"));
  ASSERT_TRUE(result) << result.error;
  const BodyDef& body = result.scene.bodies.at(0);
  EXPECT_EQ(result.scene.body_names.at(0), "it");
  EXPECT_EQ(body.kind, BodyKind::Kinematic);
  EXPECT_EQ(body.mass, Real(12.5));
  EXPECT_EQ(body.pose.position, Vec3(1, 2, 3));
  EXPECT_LT((body.pose.rotate(Vec3::UnitX()) - Vec3::UnitY()).norm(), 1e-6F);
  EXPECT_EQ(body.linear_velocity, Vec3(4, 5, 6));
  EXPECT_EQ(body.angular_velocity, Vec3(7, 8, 9));
  EXPECT_EQ(body.friction, Real(0.25));
  EXPECT_EQ(body.restitution, Real(0.75));
  EXPECT_EQ(body.filter.category, 2U);
  EXPECT_EQ(body.filter.mask, 4294967293U);
  EXPECT_NEAR(static_cast<double>(body.shape->volume), 8, 1e-5);
}

TEST(Scene, OrientationsSayTheSameInThreeWays) {
  // 90° about x, then 90° about z: maps x to y and y to z.
  const std::string same[] = {R"({"quaternion": [0.5, 0.5, 0.5, 0.5]})",
                              R"({"axis": [1, 1, 1], "degrees": 120})",
                              R"({"euler_degrees": [90, 0, 90]})"};
  for (const std::string& orientation : same) {
    const SceneResult result =
        load_text(with_body(R"({"orientation": )" + orientation + ", " + shape_member + "}"));
    ASSERT_TRUE(result) << result.error;
    const Pose& pose = result.scene.bodies[0].pose;
    EXPECT_LT((pose.rotate(Vec3::UnitX()) - Vec3::UnitY()).norm(), 1e-6F) << orientation;
    EXPECT_LT((pose.rotate(Vec3::UnitY()) - Vec3::UnitZ()).norm(), 1e-6F) << orientation;
  }
}

TEST(Scene, ReadsEveryWorldSetting) {
  const SceneResult result = load_text(R"({"schema": 1, "h": 0.01, "steps": 7, "world": {
      "gravity": [0, 0, -1.6], "length_unit": 2, "substeps": 3, "iterations": 5,
      "relax_iterations": 6, "pass_order": "step_by_step", "solver": "naive", "contact_model": "baumgarte",
      "rotation": "explicit", "warm_starting": false, "temporal_coherence": false,
      "sleeping": true, "threads": 3, "adaptive_threads": false, "contact_hertz": 10, "contact_damping_ratio": 2, "baumgarte": 0.1, "slop": 0.002, "max_push_speed": 4,
      "restitution_threshold": 1.5, "restitution_iterations": 9, "over_relaxation": 1.5, "rolling_resistance": 0.01,
      "check_stages": true,
      "audit_momentum": true},
      "max_penetration": 0.5, "bodies": [{)" +
                                       std::string(shape_member) + "}]}");
  ASSERT_TRUE(result) << result.error;
  const WorldSettings& settings = result.scene.settings;
  EXPECT_EQ(result.scene.h, Real(0.01));
  EXPECT_EQ(result.scene.steps, 7);
  EXPECT_EQ(result.scene.max_penetration, Real(0.5));
  EXPECT_EQ(settings.gravity, Vec3(0, 0, Real(-1.6)));
  EXPECT_EQ(settings.length_unit, 2);
  EXPECT_EQ(settings.substeps, 3);
  EXPECT_EQ(settings.iterations, 5);
  EXPECT_EQ(settings.relax_iterations, 6);
  EXPECT_EQ(settings.pass_order, PassOrder::StepByStep);
  EXPECT_EQ(settings.solver, SolverKind::Naive);
  EXPECT_EQ(settings.contact_model, ContactModel::Baumgarte);
  EXPECT_EQ(settings.rotation, RotationMethod::Explicit);
  EXPECT_FALSE(settings.warm_starting);
  EXPECT_FALSE(settings.temporal_coherence);
  EXPECT_TRUE(settings.sleeping);
  EXPECT_EQ(settings.threads, 3);
  EXPECT_FALSE(settings.adaptive_threads);
  EXPECT_EQ(settings.contact_hertz, 10);
  EXPECT_EQ(settings.contact_damping_ratio, 2);
  EXPECT_EQ(settings.baumgarte, Real(0.1));
  EXPECT_EQ(settings.slop, Real(0.002));
  EXPECT_EQ(settings.max_push_speed, 4);
  EXPECT_EQ(settings.restitution_threshold, Real(1.5));
  EXPECT_EQ(settings.restitution_iterations, 9);
  EXPECT_EQ(settings.over_relaxation, Real(1.5));
  EXPECT_EQ(settings.rolling_resistance, Real(0.01));
  EXPECT_TRUE(settings.check_stages);
  EXPECT_TRUE(settings.audit_momentum);
}

TEST(Scene, StartsFromTheSettingsOfItsQuality) {
  const auto settings_of = [](const std::string& world) {
    const SceneResult result = load_text(R"({"schema": 1, "world": {)" + world +
                                         R"(}, "bodies": [{)" + shape_member + "}]}");
    EXPECT_TRUE(result) << result.error;
    return result.scene.settings;
  };
  EXPECT_TRUE(has_quality(settings_of(""), Quality::Accurate));
  EXPECT_TRUE(has_quality(settings_of(R"("quality": "accurate")"), Quality::Accurate));
  EXPECT_TRUE(has_quality(settings_of(R"("quality": "game")"), Quality::Game));
  const WorldSettings own = settings_of(R"("substeps": 7, "quality": "game", "slop": 0.003)");
  EXPECT_EQ(own.substeps, 7);
  EXPECT_EQ(own.slop, Real(0.003));
  EXPECT_EQ(own.iterations, game_settings().iterations);
}

TEST(Scene, MakesEveryKindOfShape) {
  // Volumes in closed form. The area of a regular hexagon of radius 1 is 3·√3/2.
  const double hexagon = 1.5 * std::sqrt(3.0);
  const struct {
    const char* shape;
    int vertices;
    double volume;
  } cases[] = {
      {R"({"kind": "box", "half_extents": [1, 2, 3]})", 8, 48},
      {R"({"kind": "tetrahedron", "side": 2})", 4, 8.0 / 6},
      {R"({"kind": "prism", "sides": 6, "radius": 1, "height": 3})", 12, 3 * hexagon},
      {R"({"kind": "pyramid", "sides": 6, "radius": 1, "height": 3})", 7, hexagon},
      {R"({"kind": "hull", "points": [[0,0,0],[3,0,0],[0,3,0],[0,0,3],[0.5,0.5,0.5]]})", 4, 4.5},
      {R"({"kind": "mesh", "file": "unit_box.json", "scale": [1, 2, 3]})", 8, 48},
  };
  for (const auto& each : cases) {
    const SceneResult result =
        load_text(with_body(R"({"shape": )" + std::string(each.shape) + "}"));
    ASSERT_TRUE(result) << result.error;
    const ConvexShape& shape = *result.scene.bodies[0].shape;
    EXPECT_EQ(shape.mesh.vertex_count(), each.vertices) << each.shape;
    EXPECT_NEAR(static_cast<double>(shape.volume), each.volume, 1e-5 * each.volume) << each.shape;
  }
  const SceneResult round = load_text(with_body(
      R"({"shape": {"kind": "icosphere", "radius": 2, "subdivisions": 1}},
         {"shape": {"kind": "random_hull", "vertices": 30, "radius": 2, "seed": 4}},
         {"shape": {"kind": "mesh", "file": "bunny.obj", "scale": [0.1, 0.1, 0.1]}})"));
  ASSERT_TRUE(round) << round.error;
  EXPECT_EQ(round.scene.bodies[0].shape->mesh.vertex_count(), 42);
  EXPECT_EQ(round.scene.bodies[1].shape->mesh.vertex_count(), 30);
  // The scanned bunny is 9.9 long in the units of its file.
  EXPECT_NEAR(static_cast<double>(round.scene.bodies[2].shape->bounds.extent().x()), 0.99, 0.001);
}

TEST(Scene, BodiesShareANamedShape) {
  const SceneResult result = load_text(R"({"schema": 1,
      "shapes": {"brick": {"kind": "box", "half_extents": [1, 1, 1]}},
      "bodies": [{"shape": "brick"}, {"shape": "brick"}]})");
  ASSERT_TRUE(result) << result.error;
  EXPECT_EQ(result.scene.bodies[0].shape, result.scene.bodies[1].shape);
}

std::vector<BodyDef> generated(const std::string& generator) {
  const SceneResult result = load_text(R"({"schema": 1, "generators": [)" + generator + "]}");
  EXPECT_TRUE(result) << result.error;
  return result.scene.bodies;
}

TEST(Scene, GeneratorsPlaceBodies) {
  const std::string body = body_member;
  const auto at = [](const std::vector<BodyDef>& bodies, std::size_t i) {
    return bodies.at(i).pose.position;
  };
  const auto grid =
      generated(R"({"kind": "grid", "count": [3, 2, 2], "spacing": [2, 3, 4], )" + body + "}");
  ASSERT_EQ(grid.size(), 12U);
  EXPECT_EQ(at(grid, 0), Vec3(-2, -1.5F, 0.5F));
  EXPECT_EQ(at(grid, 11), Vec3(2, 1.5F, 4.5F));

  const auto stack = generated(R"({"kind": "stack", "count": 4, "gap": 0.5, )" + body + "}");
  ASSERT_EQ(stack.size(), 4U);
  EXPECT_EQ(at(stack, 3), Vec3(0, 0, 5));

  const auto wall = generated(R"({"kind": "wall", "columns": 3, "rows": 2, )" + body + "}");
  ASSERT_EQ(wall.size(), 6U);
  EXPECT_EQ(at(wall, 0), Vec3(-0.75F, 0, 0.5F));
  EXPECT_EQ(at(wall, 3), Vec3(-1.25F, 0, 1.5F)) << "the second row is half a brick aside";

  const auto pyramid = generated(R"({"kind": "pyramid", "rows": 20, )" + body + "}");
  ASSERT_EQ(pyramid.size(), 210U);
  EXPECT_EQ(at(pyramid, 209), Vec3(0, 0, 19.5F));

  const auto line =
      generated(R"({"kind": "line", "count": 3, "spacing": 2, "turn_degrees": 90, )" + body + "}");
  ASSERT_EQ(line.size(), 3U);
  EXPECT_LT((at(line, 1) - Vec3(2, 0, 0.5F)).norm(), 1e-6F);
  EXPECT_LT((at(line, 2) - Vec3(2, 2, 0.5F)).norm(), 1e-6F);
}

TEST(Scene, DropsAreRandomAndRepeatable) {
  const auto drop = [](int seed) {
    return generated(R"({"kind": "drop", "count": 30, "columns": [4, 4], "spacing": [2, 2, 2],
                        "vertices": [16, 32], "body": {}, "seed": )" +
                     std::to_string(seed) + "}");
  };
  const auto first = drop(1);
  const auto again = drop(1);
  const auto other = drop(2);
  ASSERT_EQ(first.size(), 30U);
  int equal_to_other = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_GE(first[i].shape->mesh.vertex_count(), 16);
    EXPECT_LE(first[i].shape->mesh.vertex_count(), 32);
    EXPECT_EQ(first[i].shape->mesh.vertices, again[i].shape->mesh.vertices);
    EXPECT_EQ(first[i].pose.orientation.coeffs(), again[i].pose.orientation.coeffs());
    equal_to_other +=
        first[i].pose.orientation.coeffs() == other[i].pose.orientation.coeffs() ? 1 : 0;
  }
  EXPECT_EQ(equal_to_other, 0);
}

// Name and title are printed, and a terminal would obey them.
TEST(Scene, IsNamedLikeItsFileWithoutControlCharacters) {
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder / "cs550_\033[2Jscene.json";
  std::ofstream(file) << with_body(std::string("{") + shape_member + "}");
  const Scene scene = load_scene(file).scene;
  EXPECT_EQ(scene.name, "cs550_?[2Jscene");
  EXPECT_EQ(scene.title, scene.name);
}

TEST(Scene, FindsScenesByNameAndPath) {
  EXPECT_EQ(find_scene("stack10").scene.name, "stack10");
  const TemporaryScene scene(with_body("{" + std::string(shape_member) + "}"));
  EXPECT_TRUE(find_scene(scene.file().string()));

  const SceneResult none = find_scene("stack11");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error.find("did you mean \"stack10\"?"), std::string::npos) << none.error;
  EXPECT_EQ(fault_of_scene_name("stack11"), none.error);
  EXPECT_NE(fault_of_scene_name("bunny").find("did you mean \"bunny_and_teapot\"?"),
            std::string::npos)
      << "the only one that begins so";
  EXPECT_EQ(fault_of_scene_name("stack10"), "");
  for (const std::string& name : shipped_scenes()) {
    EXPECT_NE(none.error.find(name), std::string::npos) << none.error;
  }
}

TEST(Scene, APathNamesThatFileAndNoOtherBesideIt) {
  const TemporaryScene scene(with_body("{" + std::string(shape_member) + "}"));
  const std::filesystem::path beside = scene.file().string() + ".json";
  std::ofstream(beside) << "{ no scene";
  EXPECT_TRUE(find_scene(scene.file().string()));
  std::filesystem::remove(beside);
}

TEST(Scene, AssetsFolderCanBeChosenWhenTheProgramRuns) {
  const test::ScratchFolder empty;
  {
    const test::ScopedEnvironment assets("CS550_ASSETS", empty.path().string());
    EXPECT_TRUE(shipped_scenes().empty());
  }
  EXPECT_FALSE(shipped_scenes().empty());
}

TEST(Scene, ShipsTheScenesOfTheCourse) {
  const std::vector<std::string> expected = {
      "bounce",  "box_pile",      "bunny_and_teapot", "collisions",    "dominoes",      "free_spin",
      "ghosts",  "hull_pile",     "incline",          "newton_cradle", "over_the_edge", "pyramid20",
      "stack10", "standing_wall", "thrown_shapes",    "wall"};
  const std::set<std::string> without_contacts = {"free_spin", "ghosts", "over_the_edge",
                                                  "thrown_shapes"};
  EXPECT_EQ(shipped_scenes(), expected);
  for (const std::string& name : expected) {
    const SceneResult result = find_scene(name);
    ASSERT_TRUE(result) << result.error;
    EXPECT_NE(result.scene.title, name);
    EXPECT_FALSE(result.scene.description.empty()) << name;
    EXPECT_EQ(result.scene.bodies.size(), result.scene.body_names.size()) << name;
    EXPECT_TRUE(result.scene.max_penetration > 0 || without_contacts.count(name) == 1) << name;
    EXPECT_EQ(make_world(result.scene).body_count(), static_cast<int>(result.scene.bodies.size()));
  }
}

TEST(Scene, CountsOfTheBigScenes) {
  EXPECT_EQ(find_scene("wall").scene.bodies.size(), 212U) << "floor, bunny, 210 bricks";
  EXPECT_EQ(find_scene("pyramid20").scene.bodies.size(), 211U) << "floor, 210 boxes";
  EXPECT_EQ(find_scene("hull_pile").scene.bodies.size(), 517U) << "pit of 5, 512 hulls";
}

}  // namespace
}  // namespace cs550
