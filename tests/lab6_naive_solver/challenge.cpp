// How precise the effective mass of needles is.
#include <cs550/challenge.hpp>

#include <limits>

#include "lab6_naive_solver/collision.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

[[maybe_unused]] const bool added = add_challenge(
    {"largest error of the effective mass of 2000 needles, in roundings", Better::Fewer, [] {
       constexpr double rounding = std::numeric_limits<Real>::epsilon();
       const Vec3 needle(1, Real(0.02), Real(0.02));
       Random random(66);
       double worst = 0;
       for (int i = 0; i < 2000; ++i) {
         const SolverBody a = movable(1, needle, random.orientation());
         const SolverBody b = movable(1000, needle, random.orientation());
         const Vec3 r_a = random.unit_vector();
         const Vec3 r_b = random.unit_vector();
         const Vec3 d = random.unit_vector();
         const double exact = dense_effective_mass(a, b, r_a, r_b, d);
         const double got = effective_mass(a, b, r_a, r_b, d);
         worst = std::max(worst, std::abs(got - exact) / exact);
       }
       return std::lround(worst / rounding);
     }});

}  // namespace
}  // namespace cs550::test
