// Wrong scene files: each is refused as a whole, with the place of the fault and an example that works.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"
#include "engine/scene_text.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/scoped_environment.hpp"

namespace cs550 {
namespace {

/// Checks that the scene is rejected as a whole, with a message that contains all the parts.
void expect_refused(const std::string& text, const std::vector<std::string>& parts,
                    const SceneLimits& limits = {}) {
  const TemporaryScene scene(text);
  const SceneResult result = load_scene(scene.file(), limits);
  ASSERT_FALSE(result) << text;
  EXPECT_TRUE(result.scene.bodies.empty()) << text;
  EXPECT_NE(result.error.find(scene.file().string()), std::string::npos) << result.error;
  for (const std::string& part : parts) {
    EXPECT_NE(result.error.find(part), std::string::npos)
        << "missing: " << part << "\nin: " << result.error;
  }
}

TEST(Scene, RefusesWhatFloatCannotHold) {
  const auto needle = [](const std::string& thickness) {
    return R"({"shape": {"kind": "box", "half_extents": [1, )" + thickness + ", " + thickness +
           "]}}";
  };
  EXPECT_EQ(load_text(with_body(needle("0.001"))).error, "");
  expect_refused(with_body(needle("0.0005")), {"/bodies/0: ", "found 2e+06", "thicker"});

  const auto weighing = [](const std::string& mass) {
    return "{" + std::string(shape_member) + R"(, "mass": )" + mass + "}";
  };
  EXPECT_EQ(load_text(with_body(weighing("1e-3") + ", " + weighing("1e5"))).error, "");
  expect_refused(with_body(weighing("1e-3") + ", " + weighing("1e7")),
                 {"/bodies/0: ", "0.001 kg beside 1e+07 kg of /bodies/1"});
}

/// Each number is in its range, and so is the needle, but not what a step makes of them.
TEST(Scene, RefusesProductsThatFloatCannotHold) {
  const auto cube = [](const std::string& half, const std::string& density,
                       const std::string& more = "") {
    return R"({"shape": {"kind": "box", "half_extents": [)" + half + ", " + half + ", " + half +
           R"(]}, "density": )" + density + more + "}";
  };
  const std::string spin = R"(, "angular_velocity": [1e6, 0, 0])";
  const std::string speed = R"(, "linear_velocity": [1e6, 0, 0])";
  expect_refused(with_body(cube("1e6", "1e6", spin)), {"/bodies/0: ", "mass", "1e+15", "8e+24"});
  expect_refused(with_body(cube("1e6", "1e-6", spin)), {"energy of the rotation", "1e+30"});
  expect_refused(with_body(cube("1", "1") + ", " + cube("1e3", "1e3", speed)),
                 {"/bodies/1: ", "momentum", "1e+18", "8e+18", "\"linear_velocity\": [0, 0, 0]"});
  expect_refused(with_body(cube("1e-6", "1e-6")), {"/bodies/0: ", "moments of inertia", "1e-30"});
  // 8e-18 kg, 1 mm from the middle to the ends, 5.3e-30 kg m² about the axis.
  const std::string needle = R"({"kind": "box", "half_extents": [1e-3, 1e-6, 1e-6]})";
  expect_refused(with_body(R"({"density": 1e-3, "shape": )" + needle + "}"),
                 {"/bodies/0: ", "1/mass + radius²/(smallest moment of inertia)", "at most 1e+18",
                  "found 1.88e+23", "\"density\": 375"});
  expect_refused(with_body(cube("1e3", "0.12", spin)),
                 {"/bodies/0: ", "speed of its surface by rotation", "at most 1e+18",
                  "\"angular_velocity\": [0, 0, 0]"});
  expect_refused(R"({"schema": 1, "world": {"gravity": [0, 0, 1e6]}, "h": 1, "bodies": [)" +
                     cube("1e5", "0.01") + "]}",
                 {"/bodies/0: ", "momentum in kg m/s after the first step", "found 8e+19"});
  expect_refused(R"({"schema": 1, "generators": [{"kind": "stack", "count": 1, "body": )" +
                     cube("1", "1") + R"(}, {"kind": "stack", "count": 2, "body": )" +
                     cube("1e6", "1e6") + "}]}",
                 {"/generators/1: ", "mass"});
}

/// The largest and the smallest bodies that are read stay finite in their first step.
TEST(Scene, WhatIsReadCanBeStepped) {
  const std::string halves[] = {"1e-6", "1e-3", "1", "1e3", "1e6"};
  const std::string densities[] = {"1e-6", "1e-3", "0.12", "1e3", "1e6"};
  const std::string speeds[] = {"0", "1", "1e3", "1e6"};
  int read = 0;
  for (const std::string& half : halves) {
    for (const std::string& density : densities) {
      for (const std::string& speed : speeds) {
        for (const std::string& spin : speeds) {
          const SceneResult result = load_text(with_body(
              R"({"shape": {"kind": "box", "half_extents": [)" + half + ", " + half + ", " + half +
              R"(]}, "density": )" + density + R"(, "linear_velocity": [)" + speed +
              R"(, 0, 0], "angular_velocity": [0, )" + spin + ", " + spin + "]}"));
          if (!result) continue;
          ++read;
          World world = make_world(result.scene);
          ASSERT_TRUE(std::isfinite(energy(world, result.scene.h).total()));
          world.step(result.scene.h);
          EXPECT_TRUE(is_finite(world))
              << half << " m, " << density << " kg/m³, " << speed << " m/s, " << spin << " rad/s";
        }
      }
    }
  }
  EXPECT_GT(read, 200) << "of 400";
}

TEST(Scene, RefusesWithPlaceExpectationAndExample) {
  const std::string shape = shape_member;
  expect_refused(with_body(R"({"shape": {"kind": "bax", "half_extents": [1, 1, 1]}})"),
                 {"/bodies/0/shape/kind", "\"box\"", "did you mean", "found \"bax\"",
                  "for example \"kind\": "});
  expect_refused(with_body("{" + shape + "}, {" + shape + R"(, "friction": -1})"),
                 {"/bodies/1/friction", "0 or more", "-1", "for example \"friction\": 0.6"});
  expect_refused(with_body("{" + shape + R"(, "restitution": 1.5})"),
                 {"/bodies/0/restitution", "0 to 1"});
  expect_refused(with_body("{" + shape + R"(, "mass": 0})"),
                 {"/bodies/0/mass", "from 1e-09 to 1e+12"});
  expect_refused(with_body("{" + shape + R"(, "mass": 1, "density": 1})"),
                 {"/bodies/0: ", "\"mass\" or \"density\", found both; remove one of the two"});
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
  const std::string shape = shape_member;
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
  expect_refused(R"({"schema": 1, "title": "\u009b2J"})",
                 {"/title", "control characters", "\"?2J"});
  expect_refused(
      with_body(R"({"shape": {"kind": "hull", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1e39]]}})"),
      {"/bodies/0/shape/points/3", "three numbers", "[0,0,1e+39]"});
}

/// A message repeats what it found, but no more than a line of it, and nothing that a terminal obeys.
TEST(Scene, RepeatsLongAndUnprintableTextInShort) {
  const std::string letters(5000, 'a');
  const std::string odd[] = {
      R"({"schema": 1, ")" + letters + R"(": 1, "bodies": [{)" + shape_member + "}]}",
      R"({"schema": 1, ")" + letters + R"(": 1, ")" + letters + R"(": 1})",
      R"({"schema": 1, "shapes": {")" + letters + R"(": {}}, "bodies": [{)" + shape_member + "}]}",
      R"({"schema": 1, "\u001b[2J": 1, "bodies": [{)" + std::string(shape_member) + "}]}",
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
  const std::string body = std::string(body_member) + "}";
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
      {"/generators/0/count", "500000 vertices", "found 50000000", "CS550_MAX_TOTAL_POINTS"});
  // All in one place, so that every two of them would be a pair.
  expect_refused(
      generator(R"("kind": "grid", "count": [100, 100, 2], "spacing": [1e-6, 1e-6, 1e-6], )" +
                body),
      {"100000 pairs", "CS550_MAX_PAIRS"});
}

TEST(Scene, RefusesTooMuchInAllGeneratorsAndShapesTogether) {
  SceneLimits limits;
  limits.total_points = 1000;
  const std::string drop =
      R"({"kind": "drop", "count": 13, "columns": [9, 9], "spacing": [9, 9, 9], "seed": 1, "body": {}, )";
  expect_refused(R"({"schema": 1, "generators": [)" + drop + R"("shapes": "boxes"}, )" + drop +
                     R"("vertices": [4, 30]}, )" + drop + R"("vertices": [4, 40]}]})",
                 {"/generators/2/count", "1000 vertices", "found 1014"}, limits);
  // Each body has a shape of its own.
  const std::string ball = R"({"shape": {"kind": "icosphere", "radius": 1}})";
  std::string balls = ball;
  for (int i = 1; i < 7; ++i) balls += ", " + ball;
  expect_refused(with_body(balls), {"/bodies/6/shape", "vertices of all shapes", "found 1134"},
                 limits);
}

TEST(Scene, RefusesMoreMemoryThanIsAllowed) {
  const auto grid = [](const std::string& spacing) {
    return R"({"schema": 1, "generators": [{"kind": "grid", "count": [100, 10, 1], "spacing": )" +
           spacing + ", " + body_member + "}]}";
  };
  SceneLimits limits;
  limits.memory_mb = 1;
  expect_refused(grid("[2, 2, 2]"),
                 {"/generators/0/count: ", "at most 1 MB", "2 MB with these 1000 bodies",
                  "CS550_MAX_MEMORY_MB"},
                 limits);
  limits.memory_mb = 3;
  EXPECT_EQ(load_scene(TemporaryScene(grid("[2, 2, 2]")).file(), limits).error, "");
  expect_refused(grid("[2, 0.3, 2]"), {"/: ", "at most 3 MB", "pairs of bodies"}, limits);
  expect_refused(R"({"schema": 1, "title": ")" + std::string(100000, 'a') + "\"}",
                 {"/: ", "at most 3 MB", "bytes of text"}, limits);
}

/// Generators copy it into each body.
TEST(Scene, RefusesNamesThatWouldFillTheMemory) {
  const auto named = [](std::size_t letters) {
    return with_body(R"({"name": ")" + std::string(letters, 'a') + "\", " + shape_member + "}");
  };
  EXPECT_EQ(load_text(named(200)).error, "");
  expect_refused(named(201), {"/bodies/0/name", "at most 200 bytes"});
}

/// The number of letters to change takes the product of both lengths to count.
TEST(Scene, SuggestsNothingForWordsOfThousandsOfLetters) {
  const std::string name(50000, 'a');
  const std::string text =
      R"({"schema": 1, "shapes": {")" + name +
      R"(": {"kind": "box", "half_extents": [1, 1, 1]}}, "bodies": [{"shape": ")" + name +
      R"(b"}]})";
  expect_refused(text, {"/bodies/0/shape"});
  EXPECT_EQ(load_text(text).error.find("did you mean"), std::string::npos);
}

TEST(Scene, RefusesADropWhoseSmallestBodyIsTheLargest) {
  const auto drop = [](const std::string& members, const std::string& body = "{}") {
    return R"({"schema": 1, "generators": [{"kind": "drop", "count": 3, "columns": [9, 9], "spacing": [9, 9, 9], )"
           R"("seed": 1, )" +
           members + R"("body": )" + body + "}]}";
  };
  EXPECT_EQ(load_text(drop(R"("smallest": [0.5, 0.5, 0.5], )")).error, "");
  expect_refused(drop(R"("smallest": [0.3, 0.6, 0.3], )"),
                 {"/generators/0/smallest", "no more than \"largest\""});
  expect_refused(drop(R"("largest": [0.3, 0.2, 0.3], )"),
                 {"/generators/0/largest", "no less than \"smallest\""});
  expect_refused(drop("", R"({"orientation": {"axis": [0, 0, 1], "degrees": 45}})"),
                 {"/generators/0/body/orientation", "at random"});
}

TEST(Scene, RefusesMeshFilesBeyondTheLimits) {
  for (const std::string& file : {test::fixture_file("cube"), std::string("bunny.obj")}) {
    const std::string text = with_body(R"({"shape": {"kind": "mesh", "file": ")" + file + R"("}})");
    EXPECT_EQ(load_text(text).error, "");
    SceneLimits few_points;
    few_points.hull_points = 7;
    expect_refused(text, {"/bodies/0/shape/file: expected at most 7 points, found "}, few_points);
    SceneLimits few_in_all;
    few_in_all.total_points = 7;
    expect_refused(text, {"/bodies/0/shape/file: ", "CS550_MAX_TOTAL_POINTS"}, few_in_all);
  }
}

TEST(Scene, LimitsCanBeRaisedByTheEnvironment) {
  const std::string text = R"({"schema": 1, "generators": [{"kind": "stack", "count": 12, )" +
                           std::string(body_member) + "}]}";
  {
    const test::ScopedEnvironment limit("CS550_MAX_BODIES", "11");
    expect_refused(text, {"at most 11 bodies", "found 12"}, SceneLimits::from_environment());
  }
  const test::ScopedEnvironment limit("CS550_MAX_BODIES", "12");
  EXPECT_TRUE(load_text(text));
}

TEST(Scene, RefusesLimitsThatAreNoNumbers) {
  const std::string scene = with_body("{" + std::string(shape_member) + "}");
  for (const char* variable :
       {"CS550_MAX_BODIES", "CS550_MAX_HULL_POINTS", "CS550_MAX_TOTAL_POINTS", "CS550_MAX_PAIRS",
        "CS550_MAX_MEMORY_MB"}) {
    for (const char* value : {"many", "0", "-1", "1e6", "", "99999999999", "12 "}) {
      const test::ScopedEnvironment limit(variable, value);
      const std::string error = load_text(scene).error;
      EXPECT_NE(error.find(variable), std::string::npos) << value << ": " << error;
      EXPECT_NE(error.find("found \"" + std::string(value) + "\""), std::string::npos) << error;
    }
  }
  EXPECT_EQ(load_text(scene).error, "");
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
  const std::string shape = shape_member;
  const std::string huge = R"("shape": {"kind": "box", "half_extents": [1e6, 1e6, 1e6]})";
  const std::string wrong[] = {
      with_body("{" + huge + R"(, "density": 1e6})"),
      with_body("{" + huge + R"(, "density": 1e-6, "angular_velocity": [1e6, 0, 0]})"),
      with_body("{" + huge + R"(, "density": 1e-6, "linear_velocity": [1e6, 0, 0]})"),
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

TEST(Scene, WithoutShippedScenesAMessageSaysWhereTheyWereLookedFor) {
  const test::ScopedEnvironment assets("CS550_ASSETS", "/nonexistent");
  const std::string error = find_scene("wall").error;
  EXPECT_NE(error.find("None is in /nonexistent/scenes; CS550_ASSETS"), std::string::npos) << error;
  EXPECT_EQ(error.find("one of"), std::string::npos) << error;
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
  const std::string shape = shape_member;
  expect_refused(with_body("{" + shape + R"(, "densty": 3})"),
                 {"/bodies/0/densty", "did you mean \"density\"?"});
  expect_refused(with_body(R"({"shape": {"kind": "box", "half_extents": [1, 1, 1], "radius": 2}})"),
                 {"/bodies/0/shape/radius"});
  expect_refused(with_body(R"({"shape": {"kind": "box", "half_extent": [1, 1, 1]}})"),
                 {"\"half_extents\" is missing", "did you mean \"half_extent\"?"});
  expect_refused(R"({"schema": 1, "world": {"gravitiy": [0, 0, 0]}})", {"/world", "\"gravity\""});
  expect_refused(R"({"schema": 1, "bodys": []})", {"/bodys", "\"bodies\""});
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

}  // namespace
}  // namespace cs550
