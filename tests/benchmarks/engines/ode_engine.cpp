/// ODE with its iterative solver and its default settings, beyond what a scene asks for. Its convex
/// hulls fail for cubes that touch exactly, so a scene of boxes has ODE's boxes. ODE cannot collide a
/// box with a convex, so any other scene has convexes only.
#include <ode/ode.h>

#include <cmath>

#include "benchmarks/engines/peers.hpp"

namespace cs550::bench {
namespace {

/// ODE keeps pointers to the numbers of a convex: planes as (normal, offset), points, and faces as
/// a count and indices.
struct OdeConvex {
  std::vector<dReal> planes;
  std::vector<dReal> points;
  std::vector<unsigned> faces;

  explicit OdeConvex(const ConvexShape& shape) {
    const HalfEdgeMesh& mesh = shape.mesh;
    for (const Vec3& vertex : mesh.vertices)
      points.insert(points.end(), {vertex.x(), vertex.y(), vertex.z()});
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Plane& plane = mesh.face(f).plane;
      planes.insert(planes.end(),
                    {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset});
      const std::size_t count_at = faces.size();
      faces.push_back(0);
      for (const Index e : face_edges(mesh, f)) {
        faces.push_back(static_cast<unsigned>(mesh.origin(e)));
        ++faces[count_at];
      }
    }
  }
};

Eigen::Vector3d from_ode(const dReal* v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

class OdeSimulation : public Simulation {
 public:
  OdeSimulation(const BenchScene& scene, int iterations) {
    dInitODE2(0);
    dRandSetSeed(0);  // the solver shuffles its rows
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0, 0, dReal(-9.81));
    dWorldSetQuickStepNumIterations(world_, iterations);
    convexes_.reserve(scene.bodies.size());
    const bool only_boxes = has_only_boxes(scene);
    for (const BodyDef& body : scene.bodies) {
      add(body, only_boxes ? make_box(*body.shape) : make_convex(*body.shape));
    }
  }
  ~OdeSimulation() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  OdeSimulation(const OdeSimulation&) = delete;
  OdeSimulation& operator=(const OdeSimulation&) = delete;

  void step(Real h) override {
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeSimulation*>(self)->collide(a, b);
    });
    dWorldQuickStep(world_, static_cast<dReal>(h));
    dJointGroupEmpty(contacts_);
  }

  BodyMotion motion(std::size_t index) const override {
    const dGeomID geom = geoms_[index];
    const dBodyID body = dGeomGetBody(geom);
    dQuaternion q;
    dGeomGetQuaternion(geom, q);
    BodyMotion motion;
    motion.position = from_ode(dGeomGetPosition(geom));
    motion.orientation = Eigen::Quaternion<dReal>(q[0], q[1], q[2], q[3]).cast<double>();
    if (body == nullptr) return motion;
    motion.velocity = from_ode(dBodyGetLinearVel(body));
    motion.angular_velocity = from_ode(dBodyGetAngularVel(body));
    return motion;
  }

 private:
  dGeomID make_box(const ConvexShape& shape) {
    const Vec3 size = 2 * half_extents_of_box(shape);
    return dCreateBox(space_, size.x(), size.y(), size.z());
  }

  dGeomID make_convex(const ConvexShape& shape) {
    OdeConvex& convex = convexes_.emplace_back(shape);
    const HalfEdgeMesh& mesh = shape.mesh;
    return dCreateConvex(space_, convex.planes.data(), static_cast<unsigned>(mesh.face_count()),
                         convex.points.data(), static_cast<unsigned>(mesh.vertex_count()),
                         convex.faces.data());
  }

  void add(const BodyDef& definition, dGeomID geom) {
    const ConvexShape& shape = *definition.shape;
    if (definition.kind == BodyKind::Dynamic) {
      const dBodyID body = dBodyCreate(world_);
      dMass mass;
      const Vec3 inertia = definition.density * shape.unit_inertia.diagonal();
      dMassSetParameters(&mass, definition.density * shape.volume, 0, 0, 0, inertia.x(),
                         inertia.y(), inertia.z(), 0, 0, 0);
      dBodySetMass(body, &mass);
      dGeomSetBody(geom, body);
    }
    const Quat& q = definition.pose.orientation;
    const dQuaternion orientation = {q.w(), q.x(), q.y(), q.z()};
    const Vec3& x = definition.pose.position;
    dGeomSetPosition(geom, x.x(), x.y(), x.z());
    dGeomSetQuaternion(geom, orientation);
    geoms_.push_back(geom);
    friction_ = definition.friction;
  }

  void collide(dGeomID a, dGeomID b) {
    constexpr int most = 8;
    if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
    dContactGeom points[most];
    const int count = dCollide(a, b, most, points, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.geom = points[i];
      contact.surface.mode = dContactApprox1;  // friction is bounded by μ·λ, not by a force
      contact.surface.mu = friction_;
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dGeomID> geoms_;
  std::vector<OdeConvex> convexes_;
  dReal friction_ = 0;  ///< of all bodies of the scene
};

std::unique_ptr<Simulation> start_ode(const BenchScene& scene, int iterations) {
  return std::make_unique<OdeSimulation>(scene, iterations);
}

}  // namespace

void add_ode(std::vector<Engine>& engines) {
  constexpr int usual = 20;
  engines.push_back({"ODE", "iterations", usual, {10, 20, 50, 100}, start_ode});
}

}  // namespace cs550::bench
