// How few time steps are enough for a given accuracy.
#include <cs550/challenge.hpp>

#include "lab1_integration/free_body.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added = add_challenge(
    {"steps for 1 s of a tumbling box with an error below 0.01 rad", Better::Fewer, [] {
       constexpr long fewest = 10;
       constexpr long most = 1000;
       const RigidBody start = spinning_box(racket, Vec3(Real(0.5), 5, Real(0.5)));
       FreeRotation exact(start);
       exact.advance(1);
       for (long steps = fewest; steps < most; ++steps) {
         RigidBody body = start;
         const Real h = 1 / static_cast<Real>(steps);
         for (long i = 0; i < steps; ++i) turn(body, h, RotationMethod::ImplicitMidpoint);
         if (orientation_error(body, exact.orientation()) < 0.01) return steps;
       }
       return most;
     }});

}  // namespace
}  // namespace cs550::test
