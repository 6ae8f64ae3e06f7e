// How few queries are enough when last step's axis is known.
#include <cs550/challenge.hpp>

#include "cs550/separating_axis.hpp"
#include "helpers/fixtures.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added = add_challenge(
    {"queries made while a body spins past another in 1000 steps", Better::Fewer, [] {
       constexpr int steps = 1000;
       const ShapePtr shape = fixture_shape("dodecahedron");
       const Real reach = 3 * shape->radius;
       const PosedShape still{shape.get(), {}};
       SeparatingAxis axis;
       long queries = 0;
       for (int i = 0; i < steps; ++i) {
         const Real t = static_cast<Real>(i) / steps;
         const Quat turn(Eigen::AngleAxis<Real>(20 * pi * t, Vec3(1, 2, 3).normalized()));
         const PosedShape flying{shape.get(), {{reach * (2 * t - 1), reach * Real(0.55), 0}, turn}};
         axis = find_separating_axis(still, flying, axis, 0);
         queries += (axis.face_a ? 1 : 0) + (axis.face_b ? 1 : 0) + (axis.edges ? 1 : 0);
       }
       return queries;
     }});

}  // namespace
}  // namespace cs550::test
