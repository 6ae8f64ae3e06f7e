// How many contact points keep their names.
#include <cs550/challenge.hpp>

#include <set>

#include "lab5_clipping/contacts.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added = add_challenge(
    {"points that keep their feature id: a cube turns on a cube, 900 steps", Better::More, [] {
       constexpr int steps = 900;
       const ShapePtr cube = fixture_shape("cube");
       const Index top = face_towards(cube->mesh, Vec3::UnitZ());
       const Placed below(cube, Pose{});
       std::set<std::uint32_t> names;
       long kept = 0;
       for (int i = 0; i < steps; ++i) {
         const Quat yaw = turned(Real(0.1) * static_cast<Real>(i), Vec3::UnitZ());
         const Placed above(cube, {Vec3(Real(0.1), Real(0.05), Real(0.999)), yaw});
         const Manifold manifold = face_manifold(
             below.body, above.body, face_axis(below.body, above.body, AxisFeature::FaceA, top), 0);
         std::set<std::uint32_t> now;
         for (const ContactPoint& point : manifold.points) {
           now.insert(point.feature.bits);
           kept += static_cast<long>(names.count(point.feature.bits));
         }
         names = now;
       }
       return kept;
     }});

}  // namespace
}  // namespace cs550::test
