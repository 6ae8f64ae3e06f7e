// Files and messages do not depend on the locale that a program has chosen.

#include <gtest/gtest.h>

#include <fstream>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cs550/mesh_io.hpp"
#include "cs550/mesh_validation.hpp"
#include "cs550/scene.hpp"
#include "drawing/svg.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550::test {
namespace {

/// 1.234,5 as in German. Needs no locale that is installed.
class GermanNumbers : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// The locale of the program until the end of the scope.
class ScopedLocale {
 public:
  explicit ScopedLocale(const std::locale& locale) : former_(std::locale::global(locale)) {}
  ~ScopedLocale() { std::locale::global(former_); }
  ScopedLocale(const ScopedLocale&) = delete;
  ScopedLocale& operator=(const ScopedLocale&) = delete;

 private:
  std::locale former_;
};

/// Calls a function with and without German numbers.
template <class Function>
void expect_equal_in_german(const Function& function) {
  const std::string expected = function();
  const ScopedLocale german(std::locale(std::locale::classic(), new GermanNumbers));
  ASSERT_EQ((std::ostringstream() << 1234.5).str(), "1.234,5");
  EXPECT_EQ(function(), expected);
}

/// A large cube: its numbers would be grouped.
HalfEdgeMesh cube_of_a_kilometre() {
  HalfEdgeMesh mesh = fixture_mesh("cube");
  for (Vec3& vertex : mesh.vertices) vertex *= Real(1234.5);
  for (Face& face : mesh.faces) face.plane.offset *= Real(1234.5);
  return mesh;
}

class Locale : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream stream;
    stream.imbue(std::locale::classic());
    stream.open(folder_ / name);
    stream << text;
    return (folder_ / name).string();
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Locale, AMeshIsWrittenAndReadAsEver) {
  expect_equal_in_german([&] {
    const std::string text = to_json(cube_of_a_kilometre());
    const MeshResult result = load_mesh_json(file("cube.json", text));
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.mesh.vertices, cube_of_a_kilometre().vertices);
    return text;
  });
}

TEST_F(Locale, AnObjFileIsReadAsEver) {
  const std::string obj = file("mesh.obj", "v 1234.5 0 0\nv 0 2.5e3 0\nv 0 0 0.25\nf 1 2 3\n");
  expect_equal_in_german([&] {
    const SoupResult result = load_obj(obj);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.soup.vertices,
              (std::vector<Vec3>{{Real(1234.5), 0, 0}, {0, 2500, 0}, {0, 0, Real(0.25)}}));
    return load_obj(file("wrong.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1234\n")).error;
  });
}

TEST_F(Locale, ASceneIsReadAsEver) {
  const std::string body =
      R"("bodies": [{"position": [1234.5, 0, 0.25], "mass": 2.5e3,
                     "shape": {"kind": "box", "half_extents": [0.5, 1, 2]}}]})";
  const std::string scene = file("scene.json", R"({"schema": 1, )" + body);
  const std::string wrong =
      file("wrong.json", R"({"schema": 1, "world": {"over_relaxation": 1234.5}, )" + body);
  expect_equal_in_german([&] {
    const SceneResult result = load_scene(scene);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.scene.bodies.at(0).pose.position, Vec3(Real(1234.5), 0, Real(0.25)));
    EXPECT_EQ(result.scene.bodies.at(0).mass, Real(2500));
    return load_scene(wrong).error;
  });
}

TEST_F(Locale, PicturesAreDrawnAsEver) {
  expect_equal_in_german([] {
    drawing::Drawing drawing;
    drawing.points.push_back({{Real(1234.5), 0, 0}, drawing::Role::Expected, 4});
    drawing.points.push_back({{0, Real(5678.25), 0}, drawing::Role::Got, 4});
    drawing::Plot plot;
    plot.title = "Energy";
    drawing::add_series(plot, "total", {{0, 0}, {1, Real(1234.5)}, {2, Real(98765.5)}});
    const drawing::Size size{2000, 1500};
    return write_svg(drawing, {}, size) + write_svg(plot, size);
  });
}

/// The message of a world with this change of its settings.
template <class Change>
std::string refusal_of_settings(const Change& change) {
  World world;
  change(world.settings());
  try {
    world.step(Real(1) / 60);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST_F(Locale, MessagesHaveTheirNumbersAsEver) {
  expect_equal_in_german(
      [] { return refusal_of_settings([](WorldSettings& s) { s.substeps = 1234; }); });
  expect_equal_in_german(
      [] { return refusal_of_settings([](WorldSettings& s) { s.over_relaxation = 2.5F; }); });
  expect_equal_in_german([] {
    HalfEdgeMesh mesh = cube_of_a_kilometre();
    mesh.edges[0].vertex = 1234;
    const std::optional<MeshDefect> defect = validate(mesh);
    return defect ? defect->sentence : "none";
  });
  expect_equal_in_german([] {
    std::vector<Vec3> far = fixture_mesh("cube").vertices;
    for (Vec3& point : far) point.x() += 1e6F;
    return convex_hull(far).error;
  });
}

}  // namespace
}  // namespace cs550::test
