#include "stack.hpp"

#include "sketch.hpp"

namespace cs550::book {

void add_floor(World& world, Real friction) {
  BodyDef def;
  def.kind = BodyKind::Static;
  def.shape = box({50, 50, Real(0.5)});
  def.pose.position = {0, 0, Real(-0.5)};
  def.friction = friction;
  world.add_body(def);
}

BodyId add_box(World& world, const Vec3& half_extents, const Pose& pose, Real friction,
               Real restitution) {
  BodyDef def;
  def.shape = box(half_extents);
  def.pose = pose;
  def.friction = friction;
  def.restitution = restitution;
  return world.add_body(def);
}

World stack_of_boxes(int count, SolverKind solver, int iterations) {
  WorldSettings settings;
  settings.solver = solver;
  settings.iterations = iterations;
  World world(settings);
  add_floor(world);
  for (int i = 0; i < count; ++i) {
    add_box(world, Vec3::Constant(Real(0.5)),
            {Vec3(0, 0, static_cast<Real>(i) + Real(0.5)), Quat::Identity()});
  }
  return world;
}

}  // namespace cs550::book
