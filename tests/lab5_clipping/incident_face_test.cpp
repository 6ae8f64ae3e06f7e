// L5.2: the choice of the incident face.
#include <algorithm>
#include <cs550/graded_test.hpp>
#include <numeric>

#include "lab5_clipping/contacts.hpp"
#include "lab5_clipping/pictures.hpp"

namespace cs550::test {
namespace {

Story with_incident_causes(Story story) {
  return story
      .likely("the normals of the mesh are in the body frame: turn the reference normal there")
      .likely("a direction is turned, never translated: unrotate(), not to_body()")
      .likely("anti-parallel is the *smallest* n·n_f; the largest is the face on the far side");
}

Index deepest_vertex(const PosedShape& body, const Vec3& reference_normal) {
  const Vec3 normal = body.pose.unrotate(reference_normal);
  Index deepest = 0;
  for (Index v = 1; v < body.mesh().vertex_count(); ++v) {
    if (normal.dot(body.mesh().vertex(v)) < normal.dot(body.mesh().vertex(deepest))) deepest = v;
  }
  return deepest;
}

/// The most anti-parallel of these faces.
Index most_anti_parallel(const PosedShape& body, const Vec3& normal,
                         const std::vector<Index>& faces) {
  return *std::min_element(faces.begin(), faces.end(), [&](Index f, Index g) {
    return normal.dot(body.plane(f).normal) < normal.dot(body.plane(g).normal);
  });
}

GRADED_TEST(Lab5, IncidentFaceIsTheMostAntiParallel, 3, "L5.2") {
  Random random(53);
  Story story(
      "Of the faces at the deepest vertex, the incident face points most against the reference "
      "normal");
  story.seed(random.seed()).when("find_incident_face() for a random normal");
  int without_the_vertex = 0;
  for (const char* name : {"cube", "box_1x2x3", "prism6", "corner_tetrahedron", "bunny_hull"}) {
    const ShapePtr shape = fixture_shape(name);
    std::vector<Index> all_faces(static_cast<std::size_t>(shape->mesh.face_count()));
    std::iota(all_faces.begin(), all_faces.end(), 0);
    for (int i = 0; i < 400; ++i) {
      const Vec3 position = random.point_in_box(Vec3(100, 100, 100));
      const PosedShape body{shape.get(), {position, random.orientation()}};
      const Vec3 normal = random.unit_vector();
      const Index vertex = deepest_vertex(body, normal);
      const Index face = find_incident_face(body, vertex, normal);

      Story here = story;
      here.given(std::string("shape ") + name)
          .given("reference normal", normal)
          .given("deepest vertex", vertex);
      require(here.expect_index("incident face", face, shape->mesh.face_count()));
      const std::vector<Index> around = faces_at(body.mesh(), vertex);
      const Index incident = most_anti_parallel(body, normal, around);
      here.picture([&] { return incident_picture(body, normal, incident, face); });
      Story at_vertex = here;
      at_vertex.likely(
          "only the faces around the vertex count: the most anti-parallel of all may not touch it");
      require(at_vertex.expect("the vertex is a corner of the face",
                               std::count(around.begin(), around.end(), face) == 1));
      here = with_incident_causes(here);
      // If the cosines of two faces differ only by rounding, both are correct.
      require(here.expect_near("cosine of the angle between the normals",
                               static_cast<double>(normal.dot(body.plane(face).normal)),
                               static_cast<double>(normal.dot(body.plane(incident).normal)), 2e-6));
      if (most_anti_parallel(body, normal, all_faces) != incident) ++without_the_vertex;
    }
  }
  // 30 ± 5 over all seeds: the bound holds for every salt of a course.
  story.expect_at_least("cases in which another face is more anti-parallel", without_the_vertex, 5);
}

GRADED_TEST(Lab5, FirstOfEquallyIncidentFacesWins, 1, "L5.2") {
  Story story("The first of several equally anti-parallel faces is the incident face");
  story.likely("of equal cosines the smaller index wins, so that the choice never depends on luck");
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape body{cube.get(), Pose{}};
  const Real third = std::sqrt(Real(1) / 3);
  for (const Vec3& normal :
       {Vec3(-third, -third, third), Vec3(third, -third, -third), Vec3(-third, third, -third)}) {
    const Index vertex = deepest_vertex(body, normal);
    const std::vector<Index> faces = faces_at(cube->mesh, vertex);
    Story here = story;
    here.given("a cube that is not turned").given("reference normal", normal);
    here.expect_equal("face", find_incident_face(body, vertex, normal), faces.front());
  }
}

}  // namespace
}  // namespace cs550::test
