#include "pages/labs/stack.hpp"

#include <algorithm>

#include "pages/base/colours.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {
namespace {

// Upright boxes: the first corner of a face takes too much of the load, and must give it back. In a stack of
// flat boxes impulses only grow, so that the solvers of labs 6 and 7 differ in the order of their passes only.
const Vec3 half_extents(Real(0.3), Real(0.3), Real(0.45));  // m
constexpr Real gravity = Real(9.81);                        // m/s²
constexpr Real ground_thickness = Real(0.2);                // m, half

SolverBody falling_box(Real mass) {
  const Vec3 squared = half_extents.cwiseAbs2();
  const Vec3 inertia =
      mass / 3 *
      Vec3(squared.y() + squared.z(), squared.x() + squared.z(), squared.x() + squared.y());
  SolverBody body;
  body.inverse_mass = 1 / mass;
  body.world_inverse_inertia = inertia.cwiseInverse().asDiagonal();
  body.v = {0, 0, -gravity * stack_step};
  return body;
}

/// Adds four constraints between a body and the one above it.
void add_constraints(Stack& stack, Index lower, const StackSettings& settings) {
  const Real height = stack.centers[lower + 1].z() - half_extents.z();
  for (const Real x : {Real(-1), Real(1)}) {
    for (const Real y : {Real(-1), Real(1)}) {
      const Vec3 point(x * half_extents.x(), y * half_extents.y(), height);
      ContactConstraint constraint;
      constraint.body_a = lower;
      constraint.body_b = lower + 1;
      constraint.n = Vec3::UnitZ();
      constraint.u = Vec3::UnitX();
      constraint.r_a = point - stack.centers[lower];
      constraint.r_b = point - stack.centers[lower + 1];
      constraint.friction = settings.friction;
      constraint.restitution = settings.restitution;
      stack.constraints.push_back(constraint);
    }
  }
}

Vec3 relative_velocity(const ContactConstraint& constraint, const Stack& stack) {
  const SolverBody& a = stack.bodies[constraint.body_a];
  const SolverBody& b = stack.bodies[constraint.body_b];
  return b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a);
}

/// The unit box, scaled.
MeshPtr box_mesh(const Vec3& half) {
  HalfEdgeMesh mesh = recorded_shape(Box)->mesh;
  const Vec3 corner = mesh.vertex(0).cwiseAbs();
  for (Vec3& vertex : mesh.vertices) vertex = vertex.cwiseQuotient(corner).cwiseProduct(half);
  for (Face& face : mesh.faces) {
    face.plane.offset = face.plane.normal.dot(mesh.vertex(mesh.edge(face.edge).vertex));
  }
  return std::make_shared<const HalfEdgeMesh>(std::move(mesh));
}

}  // namespace

void describe(StackSettings& settings, ControlVisitor& visit) {
  visit.section("Stack");
  visit.whole({"boxes", "boxes", ""}, settings.boxes, 1, 10);
  visit.number({"top_mass", "mass of the top box", "kg"}, settings.top_mass, Real(0.1), 100);
  visit.number({"push", "sideways push", "m/s"}, settings.push, -2, 2);
}

Stack make_stack(const StackSettings& settings) {
  Stack stack;
  stack.bodies.emplace_back();
  stack.centers.emplace_back(0, 0, -ground_thickness);
  for (int i = 0; i < settings.boxes; ++i) {
    const bool is_top = i + 1 == settings.boxes;
    stack.bodies.push_back(falling_box(is_top ? settings.top_mass : 1));
    if (is_top) stack.bodies.back().v.x() += settings.push;
    stack.centers.emplace_back(0, 0, static_cast<Real>(2 * i + 1) * half_extents.z());
    add_constraints(stack, i, settings);
  }
  return stack;
}

std::vector<Solid> stack_solids(const Stack& stack) {
  std::vector<Solid> solids;
  const MeshPtr box = box_mesh(half_extents);
  for (std::size_t i = 1; i < stack.centers.size(); ++i) {
    Solid solid;
    solid.mesh = box;
    solid.pose.position = stack.centers[i];
    solid.colour = body_colour(2, static_cast<Index>(i));
    solid.colour.w() = 0.55F;
    solids.push_back(solid);
  }
  Solid ground;
  ground.mesh = box_mesh({3, 3, ground_thickness});
  ground.pose.position = stack.centers[0];
  ground.colour = ground_colour();
  ground.is_ground = true;
  solids.push_back(ground);
  return solids;
}

std::vector<Real> level_impulses(const Stack& stack) {
  std::vector<Real> sums(stack.bodies.size() - 1, 0);
  for (const ContactConstraint& constraint : stack.constraints) {
    sums[constraint.body_a] += constraint.normal_impulse;
  }
  return sums;
}

drawing::Plot plot_levels(std::span<const std::vector<Real>> history) {
  drawing::Plot plot = drawing::plot_impulses(history);
  plot.title = "Normal impulse under each box";
  plot.y_label = "N·s";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    plot.series[i].name = "box " + std::to_string(i + 1);
    plot.series[i].dashed = i >= drawing::series_role_count;  // the colours begin again
  }
  return plot;
}

Real approach_velocity(const ContactConstraint& constraint, const Stack& stack) {
  return constraint.n.dot(relative_velocity(constraint, stack));
}

Real approach_error(const Stack& stack) {
  Real error = 0;
  for (const ContactConstraint& constraint : stack.constraints) {
    error = std::max(error, -approach_velocity(constraint, stack));
  }
  return error;
}

Stack without_friction(Stack stack) {
  for (ContactConstraint& constraint : stack.constraints) constraint.friction = 0;
  return stack;
}

std::vector<SolverBody> frictionless_answer(const Stack& start) {
  std::vector<SolverBody> answer = start.bodies;
  const Real e = start.constraints.front().restitution;
  for (SolverBody& body : answer) body.v.z() *= -e;
  return answer;
}

Real velocity_error(const Stack& stack, std::span<const SolverBody> answer) {
  Real twice_energy = 0;
  Real mass = 0;
  for (std::size_t i = 1; i < stack.bodies.size(); ++i) {
    const SolverBody& body = stack.bodies[i];
    const Vec3 v = body.v - answer[i].v;
    const Vec3 w = body.w - answer[i].w;
    mass += 1 / body.inverse_mass;
    twice_energy += v.squaredNorm() / body.inverse_mass;
    twice_energy += w.dot(body.world_inverse_inertia.inverse() * w);
  }
  return std::sqrt(twice_energy / mass);
}

drawing::Plot plot_velocity_errors(std::span<const drawing::Convergence> runs) {
  drawing::Plot plot = drawing::plot_convergence(runs, "m/s");
  plot.title = "Error of the velocities";
  plot.alt_text =
      "The distance of all velocities from the exact solution after each pass, on a log scale.";
  plot.notes = {
      "Root mean square distance, weighted by mass, from the exact velocities of this stack. All "
      "solvers run without friction here."};
  return plot;
}

Vec2 slip_velocity(const ContactConstraint& constraint, const Stack& stack) {
  const Vec3 relative = relative_velocity(constraint, stack);
  return {constraint.u.dot(relative), constraint.v().dot(relative)};
}

}  // namespace cs550::pages
