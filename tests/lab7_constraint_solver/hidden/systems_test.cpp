// Other systems of several constraints for lab 7.
#include <cs550/graded_test.hpp>

#include "helpers/story.hpp"
#include "lab7_constraint_solver/dense_lcp.hpp"
#include "lab7_constraint_solver/systems.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, PassesToAndFroFindTheDenseAnswer, 2, "L7.8") {
  Random random(7811);
  for (int i = 0; i < 24; ++i) {
    System system = line_of_cubes(6);
    if (i % 2 == 1) system = landing_box(random, Vec3(1, Real(0.2), Real(0.3)));
    for (SolverBody& body : system.bodies) body.v.x() += random.real(-1, 1);
    const DenseContacts before(system.constraints, system.bodies);
    const std::optional<Eigen::VectorXd> impulses = solve_lcp(before);
    Story story("passes forwards and backwards converge to the answer of all constraints together");
    story.seed(random.seed()).given(i % 2 == 0 ? "six cubes in a line" : "a long box that lands");
    story.when("300 passes forwards, each followed by one backwards");
    story.likely("each constraint must see what the constraints before it have done");
    require(story.expect("a solution exists", impulses.has_value()));
    ContactStep step = rigid_step();
    for (int pass = 0; pass < 600; ++pass) {
      step.backwards = pass % 2 == 1;
      system.pass(1, step);
    }
    const DenseContacts after(system.constraints, system.bodies);
    const double error = (after.velocity - before.velocity_after(*impulses)).norm();
    require(story.expect_near("distance of the velocities from the dense answer", error, 0,
                              1e-4 * (1 + before.velocity.norm()), "m/s"));
  }
}

GRADED_TEST(Lab7, BouncesOfACubeOnFourCorners, 3, "L7.9") {
  for (const Real e : {Real(0.3), Real(0.9)}) {
    Story story("corners that were hit bounce, those that are far from it are left alone");
    story.given("a cube on a floor with a step: two corners hit at 3 m/s, two 5 cm above it");
    story.given("e", e);
    story.likely("a constraint with λ_n = 0 has not been hit")
        .likely("each constraint has its own target, −e·v_n⁰");
    System box = box_on_floor(Vec3::Constant(Real(0.5)));
    for (std::size_t k = 0; k < 4; ++k) {
      box.constraints[k].restitution = e;
      box.constraints[k].approach_velocity = -3;
      box.constraints[k].normal_impulse = k < 2 ? Real(1) : Real(0);
      box.constraints[k].separation = k < 2 ? Real(0) : Real(0.05);
    }
    ContactStep step = rigid_step();
    step.restitution_threshold = 1;
    step.restitution_iterations = 40;
    apply_restitution(box.constraints, box.bodies, step);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool hit = k < 2;
      Story corner = story;
      corner.given(hit ? "a corner that was hit" : "a corner that was not");
      const Meeting meeting{box.bodies[0], box.bodies[1], box.constraints[k]};
      if (hit) {
        corner.expect_near("v_n after", meeting.contact_velocity()[0], 3 * static_cast<double>(e),
                           1e-3, "m/s");
      } else {
        corner.expect_near("λ_n after", meeting.impulses()[0], 0, 0, "N·s");
      }
      corner.expect_equal("impact handled", box.constraints[k].impact_handled, hit);
    }
  }
}

}  // namespace
}  // namespace cs550::test
