/// Bullet with its default solver and settings, beyond what a scene asks for. Boxes are
/// Bullet's boxes, all other shapes its hulls.
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "benchmarks/engines/peers.hpp"

namespace cs550::bench {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.orientation;
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}

/// Bullet grows a hull by its margin on every side, so its vertices are moved inward first. They end
/// where they were, and faces a little farther out. A box does that by itself.
std::unique_ptr<btCollisionShape> make_hull(const ConvexShape& shape) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Vec3& vertex : shape.mesh.vertices) {
    hull->addPoint(to_bullet(vertex - hull->getMargin() * vertex.normalized()), false);
  }
  hull->recalcLocalAabb();
  return hull;
}

std::unique_ptr<btCollisionShape> make_bullet_shape(const ConvexShape& shape) {
  if (!is_box(shape)) return make_hull(shape);
  return std::make_unique<btBoxShape>(to_bullet(half_extents_of_box(shape)));
}

class BulletSimulation : public Simulation {
 public:
  BulletSimulation(const BenchScene& scene, int iterations) {
    world_.setGravity({0, 0, btScalar(-9.81)});
    world_.getSolverInfo().m_numIterations = iterations;
    for (const BodyDef& body : scene.bodies) add(body);
  }
  ~BulletSimulation() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void step(Real h) override { world_.stepSimulation(h, 0); }

  BodyMotion motion(std::size_t index) const override {
    const btRigidBody& body = *bodies_[index];
    const btTransform& pose = body.getWorldTransform();
    const btQuaternion q = pose.getRotation();
    return {from_bullet(pose.getOrigin()),
            Eigen::Quaternionf(q.w(), q.x(), q.y(), q.z()).cast<double>(),
            from_bullet(body.getLinearVelocity()), from_bullet(body.getAngularVelocity())};
  }

 private:
  void add(const BodyDef& definition) {
    shapes_.push_back(make_bullet_shape(*definition.shape));
    const bool is_dynamic = definition.kind == BodyKind::Dynamic;
    const ConvexShape& shape = *definition.shape;
    const Real mass = is_dynamic ? definition.density * shape.volume : 0;
    const Vec3 inertia = definition.density * shape.unit_inertia.diagonal();
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes_.back().get(),
                                                  to_bullet(inertia));
    info.m_startWorldTransform = to_bullet(definition.pose);
    info.m_friction = std::sqrt(definition.friction);  // Bullet multiplies those of the two bodies
    info.m_restitution = definition.restitution;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(bodies_.back().get());
  }

  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
};

std::unique_ptr<Simulation> start_bullet(const BenchScene& scene, int iterations) {
  return std::make_unique<BulletSimulation>(scene, iterations);
}

}  // namespace

void add_bullet(std::vector<Engine>& engines) {
  const int usual = btContactSolverInfo().m_numIterations;
  engines.push_back({"Bullet", "iterations", usual, {5, 10, 20, 50}, start_bullet});
}

}  // namespace cs550::bench
