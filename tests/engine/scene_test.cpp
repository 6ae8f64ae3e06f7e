// Scene files: correct ones are read completely, and wrong ones are rejected with the location of
// the error.

#include "cs550/scene.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace cs550 {
namespace {

namespace fs = std::filesystem;

/// A temporary file, deleted after the test.
class TemporaryScene {
 public:
  explicit TemporaryScene(const std::string& text) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    file_ = fs::path(testing::TempDir()) / ("cs550_" + test + ".json");
    std::ofstream(file_) << text;
  }
  ~TemporaryScene() { fs::remove(file_); }
  TemporaryScene(const TemporaryScene&) = delete;
  TemporaryScene& operator=(const TemporaryScene&) = delete;

  const fs::path& file() const { return file_; }
  SceneResult load() const { return load_scene(file_); }

 private:
  fs::path file_;
};

SceneResult load_text(const std::string& text) { return TemporaryScene(text).load(); }

std::string with_body(const std::string& body) {
  return R"({"schema": 1, "bodies": [)" + body + "]}";
}

/// Checks that the scene is rejected as a whole, with a message that contains all the parts.
void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
  const TemporaryScene scene(text);
  const SceneResult result = scene.load();
  ASSERT_FALSE(result) << text;
  EXPECT_TRUE(result.scene.bodies.empty()) << text;
  EXPECT_NE(result.error.find(scene.file().string()), std::string::npos) << result.error;
  for (const std::string& part : parts) {
    EXPECT_NE(result.error.find(part), std::string::npos)
        << "missing: " << part << "\nin: " << result.error;
  }
}

constexpr const char* box = R"("shape": {"kind": "box", "half_extents": [0.5, 1, 2]})";

TEST(Scene, RefusesWhatFloatCannotHold) {
  const auto needle = [](const std::string& thickness) {
    return R"({"shape": {"kind": "box", "half_extents": [1, )" + thickness + ", " + thickness +
           "]}}";
  };
  EXPECT_EQ(load_text(with_body(needle("0.001"))).error, "");
  expect_refused(with_body(needle("0.0005")), {"/bodies/0: ", "found 2e+06", "thicker"});

  const auto weighing = [](const std::string& mass) {
    return "{" + std::string(box) + R"(, "mass": )" + mass + "}";
  };
  EXPECT_EQ(load_text(with_body(weighing("1e-3") + ", " + weighing("1e5"))).error, "");
  expect_refused(with_body(weighing("1e-3") + ", " + weighing("1e7")),
                 {"/bodies/0: ", "0.001 kg beside 1e+07 kg of /bodies/1"});
}

TEST(Scene, ReadsEveryMemberOfABody) {
  const SceneResult result = load_text(with_body(R"({
      "name": "it", "kind": "kinematic", "mass": 12.5, "position": [1, 2, 3],
      "orientation": {"axis": [0, 0, 2], "degrees": 90},
      "linear_velocity": [4, 5, 6], "angular_velocity": [7, 8, 9],
      "friction": 0.25, "restitution": 0.75, "filter": {"category": 2, "mask": 4294967293},)" +
                                                 std::string(box) + "}"));
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
        load_text(with_body(R"({"orientation": )" + orientation + ", " + box + "}"));
    ASSERT_TRUE(result) << result.error;
    const Pose& pose = result.scene.bodies[0].pose;
    EXPECT_LT((pose.rotate(Vec3::UnitX()) - Vec3::UnitY()).norm(), 1e-6F) << orientation;
    EXPECT_LT((pose.rotate(Vec3::UnitY()) - Vec3::UnitZ()).norm(), 1e-6F) << orientation;
  }
}

TEST(Scene, ReadsEveryWorldSetting) {
  const SceneResult result = load_text(R"({"schema": 1, "h": 0.01, "steps": 7, "world": {
      "gravity": [0, 0, -1.6], "length_unit": 2, "substeps": 3, "iterations": 5,
      "relax_iterations": 6, "solver": "naive", "contact_model": "baumgarte",
      "rotation": "explicit", "warm_starting": false, "temporal_coherence": true,
      "sleeping": true, "threads": 3, "contact_hertz": 10, "contact_damping_ratio": 2, "baumgarte": 0.1, "slop": 0.002, "max_push_speed": 4,
      "restitution_threshold": 1.5, "restitution_iterations": 9, "rolling_resistance": 0.01,
      "check_stages": true,
      "audit_momentum": true},
      "max_penetration": 0.5, "bodies": [{)" +
                                       std::string(box) + "}]}");
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
  EXPECT_EQ(settings.solver, SolverKind::Naive);
  EXPECT_EQ(settings.contact_model, ContactModel::Baumgarte);
  EXPECT_EQ(settings.rotation, RotationMethod::Explicit);
  EXPECT_FALSE(settings.warm_starting);
  EXPECT_TRUE(settings.temporal_coherence);
  EXPECT_TRUE(settings.sleeping);
  EXPECT_EQ(settings.threads, 3);
  EXPECT_EQ(settings.contact_hertz, 10);
  EXPECT_EQ(settings.contact_damping_ratio, 2);
  EXPECT_EQ(settings.baumgarte, Real(0.1));
  EXPECT_EQ(settings.slop, Real(0.002));
  EXPECT_EQ(settings.max_push_speed, 4);
  EXPECT_EQ(settings.restitution_threshold, Real(1.5));
  EXPECT_EQ(settings.restitution_iterations, 9);
  EXPECT_EQ(settings.rolling_resistance, Real(0.01));
  EXPECT_TRUE(settings.check_stages);
  EXPECT_TRUE(settings.audit_momentum);
}

TEST(Scene, StartsFromTheSettingsOfItsQuality) {
  const auto settings_of = [](const std::string& world) {
    const SceneResult result =
        load_text(R"({"schema": 1, "world": {)" + world + R"(}, "bodies": [{)" + box + "}]}");
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

constexpr const char* unit_box =
    R"("body": {"name": "b", "position": [0, 0, 0.5], "shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}})";

TEST(Scene, GeneratorsPlaceBodies) {
  const std::string body = unit_box;
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

TEST(Scene, RefusesWithPlaceExpectationAndExample) {
  const std::string shape = box;
  expect_refused(with_body(R"({"shape": {"kind": "bax", "half_extents": [1, 1, 1]}})"),
                 {"/bodies/0/shape/kind", "\"box\"", "did you mean", "found \"bax\"",
                  "for example \"kind\": "});
  expect_refused(with_body("{" + shape + "}, {" + shape + R"(, "friction": -1})"),
                 {"/bodies/1/friction", "0 or more", "-1", "for example \"friction\": 0.6"});
  expect_refused(with_body("{" + shape + R"(, "restitution": 1.5})"),
                 {"/bodies/0/restitution", "0 to 1"});
  expect_refused(with_body("{" + shape + R"(, "mass": 0})"),
                 {"/bodies/0/mass", "from 1e-09 to 1e+12"});
  expect_refused(with_body("{" + shape + R"(, "mass": 1, "density": 1})"), {"/bodies/0/density"});
  expect_refused(with_body("{" + shape + R"(, "position": [1, 2]})"),
                 {"/bodies/0/position", "three", "[1,2]", "[0.0, 0.0, 0.0]"});
  expect_refused(with_body("{" + shape + R"(, "position": [1, "2", 3]})"), {"/bodies/0/position"});
  expect_refused(with_body(R"({"position": [0, 0, 0]})"),
                 {"/bodies/0", "\"shape\" is missing", "\"half_extents\""});
  expect_refused(with_body(R"({"shape": {"kind": "box", "half_extents": [1, 0, 1]}})"),
                 {"/bodies/0/shape/half_extents", "positive"});
  expect_refused(with_body(R"({"shape": "brick"})"), {"/bodies/0/shape", "shapes"});
  expect_refused(with_body("{" + shape + R"(, "orientation": {"quaternion": [1, 1, 1, 1]}})"),
                 {"/bodies/0/orientation/quaternion", "unit"});
  expect_refused(with_body("{" + shape + R"(, "orientation": {"degrees": 4}})"),
                 {"/bodies/0/orientation", "\"axis\""});
  expect_refused(R"({"schema": 1, "world": {"substeps": 0}})", {"/world/substeps", "from 1"});
  expect_refused(R"({"schema": 1, "world": {"solver": "fast"}})",
                 {"/world/solver", "naive", "constraint"});
  expect_refused(R"({"schema": 2, "bodies": []})", {"/schema", "found 2"});
  expect_refused(R"({"bodies": []})", {"\"schema\" is missing"});
  expect_refused(R"({"schema": 1})", {"at least one body"});
  expect_refused(R"({"schema": 1, "bodies": {}})", {"/bodies", "list"});
  expect_refused(R"({"schema": 1, "generators": [{"kind": "wall", "rows": 3}]})",
                 {"/generators/0", "\"body\" is missing"});
}

TEST(Scene, RefusesWhatAParserWouldMisreadWithoutAWord) {
  const std::string shape = box;
  expect_refused(R"({"schema": 1, "h": 0.01, "h": 0.02})", {"/h", "each key once", "\"h\""});
  expect_refused(with_body("{" + shape + R"(, "position": [0, 0, 1], "position": [0, 0, 2]})"),
                 {"/bodies/0/position", "a second time"});
  expect_refused(R"({"schema": 1, "h": 1e30})", {"/h", "from 1e-06 to 1", "1e+30"});
  expect_refused(R"({"schema": 1, "h": 1e999})", {"/h", "1e308"});
  expect_refused(with_body("{" + shape + R"(, "mass": 3e38})"), {"/bodies/0/mass", "1e+12"});
  expect_refused(with_body("{" + shape + R"(, "position": [0, 1e39, 0]})"),
                 {"/bodies/0/position", "from -1e6 to 1e6", "1e+39"});
  expect_refused(
      with_body("{" + shape + R"(, "orientation": {"axis": [0, 0, 1e30], "degrees": 9}})"),
      {"/bodies/0/orientation/axis", "1e+30"});
  expect_refused(
      with_body("{" + shape + R"(, "orientation": {"axis": [0, 0, 1e-30], "degrees": 9}})"),
      {"/bodies/0/orientation/axis", "a direction of length"});
  expect_refused(R"({"schema": 1, "title": "\u001b[2J"})", {"/title", "control characters"});
  expect_refused(
      with_body(R"({"shape": {"kind": "hull", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1e39]]}})"),
      {"/bodies/0/shape/points/3", "three numbers", "[0,0,1e+39]"});
}

/// A message repeats what it found, but no more than a line of it, and nothing that a terminal obeys.
TEST(Scene, RepeatsLongAndUnprintableTextInShort) {
  const std::string letters(5000, 'a');
  const std::string odd[] = {
      R"({"schema": 1, ")" + letters + R"(": 1, "bodies": [{)" + box + "}]}",
      R"({"schema": 1, ")" + letters + R"(": 1, ")" + letters + R"(": 1})",
      R"({"schema": 1, "shapes": {")" + letters + R"(": {}}, "bodies": [{)" + box + "}]}",
      R"({"schema": 1, "\u001b[2J": 1, "bodies": [{)" + std::string(box) + "}]}",
      R"({"schema": 1, "shapes": {"\u001b[2J": {}}})",
      "{\"schema\": 1, \"bod\x7fies\": []}",  // and the key that it may have meant
      "{\"schema\": 1, \"generators\": [{\"kind\": \"stack\", \"c\x7funt\": 3}]}",
  };
  for (const std::string& text : odd) {
    const SceneResult result = load_text(text);
    EXPECT_FALSE(result) << text;
    EXPECT_LT(result.error.size(), 700U) << result.error;
    EXPECT_EQ(result.error.find_first_of("\033\x7f"), std::string::npos) << result.error;
  }
  expect_refused("{\"schema", {"this is not JSON: parse error at line 1"});
  EXPECT_LT(load_text("{\"" + letters).error.size(), 500U)
      << "an unfinished text is read to the end";
  EXPECT_LT(find_scene(letters).error.size(), 500U);
  EXPECT_EQ(find_scene("\033[2J").error.find('\033'), std::string::npos);
}

TEST(Scene, RefusesNestingThatNoSceneNeeds) {
  for (const int levels : {33, 100000, 1000000}) {
    const std::string open(levels, '[');
    expect_refused(R"({"schema": 1, "title": )" + open, {"/title/0/0", "at most 32 levels"});
  }
  const std::string closed = std::string(31, '[') + std::string(31, ']');
  expect_refused(R"({"schema": 1, "title": )" + closed + "}", {"/title", "a text in quotes"});
}

TEST(Scene, RefusesTooMuchBeforeItIsMade) {
  const std::string body = std::string(unit_box) + "}";
  const auto generator = [](const std::string& keys) {
    return R"({"schema": 1, "generators": [{)" + keys + "]}";
  };
  // 10¹² boxes would fill any memory; 10¹² + 1 = 1 + 10⁶·10⁶.
  expect_refused(
      generator(R"("kind": "grid", "count": [10000, 10000, 10000], "spacing": [1, 1, 1], )" + body),
      {"/generators/0/count", "50000 bodies", "found 1000000000000", "CS550_MAX_BODIES"});
  expect_refused(generator(R"("kind": "wall", "columns": 1000000, "rows": 1000000, )" + body),
                 {"/generators/0/rows", "found 1000000000000"});
  expect_refused(generator(R"("kind": "pyramid", "rows": 1000000, )" + body),
                 {"found 500000500000"});
  expect_refused(generator(R"("kind": "stack", "count": 50000, )" + body +
                           R"(, {"kind": "stack", "count": 1, )" + body),
                 {"/generators/1/count", "found 50001"});
  expect_refused(
      generator(R"("kind": "drop", "count": 50000, "columns": [9, 9], "spacing": [1, 1, 1],
                             "seed": 1, "vertices": [4, 1000], "body": {}})"),
      {"/generators/0/count", "500000 vertices", "found 50000000"});
  // All in one place, so that every two of them would be a pair.
  expect_refused(
      generator(R"("kind": "grid", "count": [100, 100, 2], "spacing": [1e-6, 1e-6, 1e-6], )" +
                body),
      {"1000000 pairs", "CS550_MAX_PAIRS"});
}

TEST(Scene, LimitsCanBeRaisedByTheEnvironment) {
  const std::string text = R"({"schema": 1, "generators": [{"kind": "stack", "count": 12, )" +
                           std::string(unit_box) + "}]}";
  setenv("CS550_MAX_BODIES", "11", 1);
  expect_refused(text, {"at most 11 bodies", "found 12"});
  setenv("CS550_MAX_BODIES", "12", 1);
  EXPECT_TRUE(load_text(text));
  setenv("CS550_MAX_BODIES", "many", 1);
  EXPECT_TRUE(load_text(text)) << "what is no number changes nothing";
  unsetenv("CS550_MAX_BODIES");
}

/// Replaces the rejected value by the example in the message, as a user would.
std::string with_example_pasted(const std::string& text, const std::string& error) {
  static const std::regex form(R"re(: (/[^:]*): .*; for example (?:"([^"]*)": )?(.*)$)re");
  std::smatch match;
  if (!std::regex_search(error, match, form)) return {};
  nlohmann::json document = nlohmann::json::parse(text);
  const std::string key = match[2];
  std::string path = match[1];
  // A missing key is added to the object at the path. Other values are replaced.
  if (path.size() < key.size() || path.substr(path.size() - key.size()) != key) {
    path += (path == "/" ? "" : "/") + key;
  }
  document[nlohmann::json::json_pointer(path)] = nlohmann::json::parse(match[3].str());
  return document.dump();
}

TEST(Scene, ExamplesInMessagesWorkWhenPasted) {
  const std::string shape = box;
  const std::string wrong[] = {
      with_body("{" + shape + R"(, "friction": -1})"),
      with_body("{" + shape + R"(, "restitution": 2})"),
      with_body("{" + shape + R"(, "position": [1, 2]})"),
      with_body("{" + shape + R"(, "mass": 0})"),
      with_body("{" + shape + R"(, "kind": "statik"})"),
      with_body("{" + shape + R"(, "orientation": {"quaternion": [1, 1, 1, 1]}})"),
      with_body("{" + shape + R"(, "orientation": {"quaternion": 1}})"),
      with_body("{" + shape + R"(, "orientation": {"axis": [0, 0, 0], "degrees": 1}})"),
      with_body("{" + shape + R"(, "filter": {"category": -1}})"),
      with_body(R"({"position": [0, 0, 0]})"),
      with_body(R"({"shape": "brick"})"),
      with_body(R"({"shape": {"kind": "bax", "half_extents": [1, 1, 1]}})"),
      with_body(R"({"shape": {"kind": "box"}})"),
      with_body(R"({"shape": {"kind": "hull"}})"),
      with_body(R"({"shape": {"kind": "hull", "points": 3}})"),
      with_body(R"({"shape": {"kind": "mesh", "file": "hare.obj"}})"),
      with_body(R"({"shape": 5})"),
      with_body("{" + shape + R"(, "orientation": []})"),
      with_body("{" + shape + R"(, "filter": "all"})"),
      R"({"schema": 1, "world": [], "bodies": [{)" + shape + "}]}",
      R"({"schema": 1, "shapes": {"brick": 5}, "bodies": [{)" + shape + "}]}",
      R"({"schema": 1, "generators": [{"kind": "stack", "count": 3, "body": 5}]})",
      R"({"schema": 1})",
      R"({"schema": 1, "bodies": {}})",
      R"({"schema": 1, "bodies": [[]]})",
      R"({"schema": 1, "generators": {}})",
      R"({"schema": 1, "generators": [5]})",
      R"({"schema": 1, "generators": [{"kind": "stack", "count": 3}]})",
      R"({"schema": 1, "h": 0, "bodies": [{)" + shape + "}]}",
      R"({"schema": 1, "steps": 0, "bodies": [{)" + shape + "}]}",
      R"({"schema": 1, "title": 5, "bodies": [{)" + shape + "}]}",
      R"({"schema": 1, "world": {"substeps": 0}, "bodies": [{)" + shape + "}]}",
      R"({"schema": 2, "bodies": [{)" + shape + "}]}",
      R"({"bodies": [{)" + shape + "}]}",
  };
  for (const std::string& text : wrong) {
    const SceneResult refused = load_text(text);
    ASSERT_FALSE(refused) << text;
    const std::string pasted = with_example_pasted(text, refused.error);
    ASSERT_NE(pasted, "") << "no example in: " << refused.error;
    EXPECT_TRUE(load_text(pasted)) << refused.error << "\nthen: " << load_text(pasted).error;
  }
}

TEST(Scene, NamesThatNoFileCanHaveAreRefused) {
  for (const std::string& name :
       {std::string(), std::string(100000, 'x'), std::string("a/b\0c", 5)}) {
    EXPECT_FALSE(find_scene(name));
    EXPECT_FALSE(load_scene(name));
    EXPECT_NE(load_scene(name).error, "");
  }
}

TEST(Scene, RefusesUnknownKeysAndNamesTheNearest) {
  const std::string shape = box;
  expect_refused(with_body("{" + shape + R"(, "densty": 3})"),
                 {"/bodies/0/densty", "did you mean \"density\"?"});
  expect_refused(with_body(R"({"shape": {"kind": "box", "half_extents": [1, 1, 1], "radius": 2}})"),
                 {"/bodies/0/shape/radius"});
  expect_refused(with_body(R"({"shape": {"kind": "box", "half_extent": [1, 1, 1]}})"),
                 {"\"half_extents\" is missing", "did you mean \"half_extent\"?"});
  expect_refused(R"({"schema": 1, "world": {"gravitiy": [0, 0, 0]}})", {"/world", "\"gravity\""});
  expect_refused(R"({"schema": 1, "body": []})", {"/body", "\"bodies\""});
}

TEST(Scene, RefusesFilesThatAreNoSceneAtAll) {
  expect_refused("{\"schema\": 1,\n \"bodies\": [}", {"not JSON", "line 2"});
  expect_refused("", {"not JSON"});
  expect_refused("[]", {"object", "for example {\"schema\": 1, \"bodies\": ["});
  EXPECT_NE(load_scene("no/such/file.json").error.find("no/such/file.json"), std::string::npos);
  EXPECT_FALSE(load_scene(testing::TempDir())) << "a folder";
}

TEST(Scene, RefusesShapesThatAreNone) {
  expect_refused(
      with_body(R"({"shape": {"kind": "hull", "points": [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]}})"),
      {"/bodies/0/shape"});
  expect_refused(with_body(R"({"shape": {"kind": "mesh", "file": "hare.obj"}})"),
                 {"/bodies/0/shape/file", "hare.obj", "meshes"});
}

TEST(Scene, FindsScenesByNameAndPath) {
  EXPECT_EQ(find_scene("stack10").scene.name, "stack10");
  const TemporaryScene scene(with_body("{" + std::string(box) + "}"));
  EXPECT_TRUE(find_scene(scene.file().string()));

  const SceneResult none = find_scene("stack11");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error.find("did you mean \"stack10\"?"), std::string::npos) << none.error;
  for (const std::string& name : shipped_scenes()) {
    EXPECT_NE(none.error.find(name), std::string::npos) << none.error;
  }
}

TEST(Scene, AssetsFolderCanBeChosenWhenTheProgramRuns) {
  setenv("CS550_ASSETS", testing::TempDir().c_str(), 1);
  const std::vector<std::string> elsewhere = shipped_scenes();
  unsetenv("CS550_ASSETS");
  EXPECT_TRUE(elsewhere.empty());
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
