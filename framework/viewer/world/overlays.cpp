#include "viewer/world/overlays.hpp"

#include <algorithm>

#include "drawing/manifold_drawing.hpp"

namespace cs550::viewer {
namespace {

using drawing::Drawing;
using drawing::Role;
using drawing::Stroke;

constexpr Stroke thin(Role role) { return {role, Real(1), false, false}; }
constexpr Stroke arrow(Role role) { return {role, Real(2.2), false, true}; }

template <class Visit>
void for_dynamic_bodies(const WorldFrame& frame, const Visit& visit) {
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    if (frame.is_alive[i] != 0 && frame.bodies[i].kind == BodyKind::Dynamic) {
      visit(frame.bodies[i]);
    }
  }
}

void add_box(Drawing& drawing, const Bounds& box, const Stroke& stroke) {
  const auto corner = [&](unsigned bits) {
    return Vec3((bits & 1U) != 0 ? box.upper.x() : box.lower.x(),
                (bits & 2U) != 0 ? box.upper.y() : box.lower.y(),
                (bits & 4U) != 0 ? box.upper.z() : box.lower.z());
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if ((from & axis) == 0) drawing.lines.push_back({corner(from), corner(from | axis), stroke});
    }
  }
}

void add_edges(Drawing& drawing, const HalfEdgeMesh& mesh, const Pose& pose, const Stroke& stroke) {
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    drawing.lines.push_back({pose.to_world(mesh.vertex(mesh.origin(e))),
                             pose.to_world(mesh.vertex(mesh.edge(e).vertex)), stroke});
  }
}

/// The largest length among some vectors; 1 if all are zero.
class Scale {
 public:
  void include(Real length) { largest_ = std::max(largest_, length); }
  /// Metres per unit, so that the largest is as long as wished.
  Real metres(Real longest) const { return largest_ > 0 ? longest / largest_ : 0; }

 private:
  Real largest_ = 0;
};

/// One vector of every dynamic body, scaled so that the longest has a set length.
template <class Vector>
void add_vectors(Drawing& drawing, const WorldFrame& frame, Real longest, Role role,
                 const Vector& vector) {
  Scale scale;
  for_dynamic_bodies(frame, [&](const RigidBody& body) { scale.include(vector(body).norm()); });
  const Real metres = scale.metres(longest);
  for_dynamic_bodies(frame, [&](const RigidBody& body) {
    const Vec3 shown = metres * vector(body);
    if (shown.norm() < Real(0.01) * longest) return;
    drawing::add_arrow(drawing, body.pose.position, shown, arrow(role));
  });
}

void add_contacts(Drawing& drawing, const Overlays& overlays, const WorldFrame& frame,
                  Real length) {
  Scale impulse_scale;
  for (const Contact& contact : frame.contacts) {
    for (const ContactPoint& point : contact.manifold.points) {
      impulse_scale.include(point.normal_impulse);
    }
  }
  const Real impulse_metres = impulse_scale.metres(3 * length);
  for (const Contact& contact : frame.contacts) {
    const Manifold& manifold = contact.manifold;
    const Pose& pose_a = frame.bodies[static_cast<std::size_t>(contact.body_a)].pose;
    const Pose& pose_b = frame.bodies[static_cast<std::size_t>(contact.body_b)].pose;
    const Vec3 v = manifold.normal.cross(manifold.tangent);
    for (const ContactPoint& point : manifold.points) {
      const Vec3 place =
          Real(0.5) * (pose_a.to_world(point.anchor_a) + pose_b.to_world(point.anchor_b));
      if (overlays.contacts) {
        drawing.points.push_back({place, Role::Got, Real(4)});
        drawing::add_arrow(drawing, place, length * manifold.normal, arrow(Role::Axis));
      }
      if (overlays.impulses) {
        const Vec3 impulse = point.normal_impulse * manifold.normal +
                             point.tangent_impulse.x() * manifold.tangent +
                             point.tangent_impulse.y() * v;
        if (impulse.norm() * impulse_metres > Real(0.03) * length) {
          drawing::add_arrow(drawing, place, impulse_metres * impulse, arrow(Role::Expected));
        }
      }
      if (overlays.feature_ids) {
        drawing.labels.push_back({place, drawing::feature_text(point.feature), Role::Text});
      }
    }
  }
}

void add_legend(Drawing& drawing, const Overlays& overlays) {
  const auto add = [&](bool wanted, const char* text, const Stroke& stroke) {
    if (wanted) drawing.legend.push_back({text, stroke});
  };
  add(overlays.contacts, "contact normal, A to B", arrow(Role::Axis));
  add(overlays.impulses, "impulse on B", arrow(Role::Expected));
  add(overlays.bounds, "bounds of a body", thin(Role::BodyA));
  add(overlays.tree, "node of the tree", thin(Role::Incident));
  add(overlays.velocities, "velocity", arrow(Role::BodyA));
  add(overlays.spins, "angular velocity", arrow(Role::Incident));
  add(overlays.momenta, "linear momentum", arrow(Role::Reference));
  add(overlays.momenta, "angular momentum", arrow(Role::Got));
}

}  // namespace

void describe(Overlays& overlays, KnobVisitor& visit) {
  visit.section("Show");
  visit.toggle({"contacts", "contact points, normals", ""}, overlays.contacts);
  visit.toggle({"impulses", "impulses", ""}, overlays.impulses);
  visit.toggle({"feature_ids", "feature ids", ""}, overlays.feature_ids);
  visit.toggle({"wireframe", "wireframe", ""}, overlays.wireframe);
  visit.toggle({"bounds", "bounds", ""}, overlays.bounds);
  visit.toggle({"tree", "broad-phase tree", ""}, overlays.tree);
  visit.toggle({"velocities", "velocities", ""}, overlays.velocities);
  visit.toggle({"spins", "angular velocities", ""}, overlays.spins);
  visit.toggle({"momenta", "momenta", ""}, overlays.momenta);
  visit.toggle({"centers", "centres of mass", ""}, overlays.centers);
}

Drawing draw_overlays(const Overlays& overlays, const WorldFrame& frame,
                      const std::vector<MeshPtr>& meshes, Real length) {
  Drawing drawing;
  if (overlays.wireframe) {
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      const Index mesh = frame.mesh_of_body[i];
      if (mesh == no_index || frame.bodies[i].kind != BodyKind::Dynamic) continue;
      add_edges(drawing, *meshes[static_cast<std::size_t>(mesh)], frame.bodies[i].pose,
                thin(Role::Axis));
    }
  }
  if (overlays.contacts || overlays.impulses || overlays.feature_ids) {
    add_contacts(drawing, overlays, frame, length);
  }
  if (overlays.tree) {
    for (const Bounds& box : frame.tree) add_box(drawing, box, thin(Role::Incident));
  }
  if (overlays.bounds) {
    for (std::size_t i = 0; i < frame.bounds.size(); ++i) {
      if (frame.is_alive[i] != 0) add_box(drawing, frame.bounds[i], thin(Role::BodyA));
    }
  }
  if (overlays.velocities) {
    add_vectors(drawing, frame, 4 * length, Role::BodyA,
                [](const RigidBody& body) { return body.linear_velocity; });
  }
  if (overlays.spins) {
    add_vectors(drawing, frame, 4 * length, Role::Incident,
                [](const RigidBody& body) { return body.angular_velocity; });
  }
  if (overlays.momenta) {
    add_vectors(drawing, frame, 4 * length, Role::Reference,
                [](const RigidBody& body) { return body.linear_momentum; });
    add_vectors(drawing, frame, 4 * length, Role::Got,
                [](const RigidBody& body) { return body.angular_momentum; });
  }
  if (overlays.centers) {
    for_dynamic_bodies(frame, [&](const RigidBody& body) {
      drawing.points.push_back({body.pose.position, Role::Axis, Real(4)});
    });
  }
  add_legend(drawing, overlays);
  return drawing::finite_part(drawing);
}

Drawing draw_selection(const HalfEdgeMesh& mesh, const Pose& pose) {
  Drawing drawing;
  add_edges(drawing, mesh, pose, {Role::Highlight, Real(2.5), false, false});
  drawing.points.push_back({pose.position, Role::Highlight, Real(5)});
  return drawing;
}

}  // namespace cs550::viewer
