// L5.2: the choice of the incident face.
#include <cs550/graded_test.hpp>

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

GRADED_TEST(Lab5, IncidentFaceIsTheMostAntiParallel, 3, "L5.2") {
  Random random(53);
  Story story = with_incident_causes(
      Story("The incident face is the one whose normal points most against the reference normal"));
  story.seed(random.seed()).when("find_incident_face() for a random normal");
  for (const char* name : {"cube", "box_1x2x3", "prism6", "corner_tetrahedron", "hull32"}) {
    const ShapePtr shape = fixture_shape(name);
    for (int i = 0; i < 200; ++i) {
      const Vec3 position = random.point_in_box(Vec3(100, 100, 100));
      const PosedShape body{shape.get(), {position, random.orientation()}};
      const Vec3 normal = random.unit_vector();
      const Index face = find_incident_face(body, normal);

      Story here = story;
      here.given(std::string("shape ") + name).given("reference normal", normal);
      require(here.expect_index("incident face", face, shape->mesh.face_count()));
      double smallest = 2;
      Index incident = no_index;
      for (Index f = 0; f < shape->mesh.face_count(); ++f) {
        const double cosine = static_cast<double>(normal.dot(body.plane(f).normal));
        if (cosine < smallest) incident = f;
        smallest = std::min(smallest, cosine);
      }
      here.picture([&] { return incident_picture(body, normal, incident, face); });
      // If the cosines of two faces differ only by rounding, both are correct.
      require(here.expect_near("cosine of the angle between the normals",
                               static_cast<double>(normal.dot(body.plane(face).normal)), smallest,
                               2e-6));
    }
  }
}

GRADED_TEST(Lab5, FirstOfEquallyIncidentFacesWins, 1, "L5.2") {
  Story story("The first of several equally anti-parallel faces is the incident face");
  story.likely(
      "only a strictly smaller cosine takes over, so that the choice never depends on luck");
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape body{cube.get(), Pose{}};
  const Real third = std::sqrt(Real(1) / 3);
  for (const Vec3& normal :
       {Vec3(-third, -third, third), Vec3(third, -third, -third), Vec3(-third, third, -third)}) {
    Index first = no_index;
    for (Index f = cube->mesh.face_count() - 1; f >= 0; --f) {
      if (cube->mesh.face(f).plane.normal.dot(normal) < 0) first = f;
    }
    Story here = story;
    here.given("a cube that is not turned").given("reference normal", normal);
    here.expect_equal("face", find_incident_face(body, normal), first);
  }
}

}  // namespace
}  // namespace cs550::test
