#include "pages/world/overlays.hpp"

#include <algorithm>

#include "drawing/manifold_drawing.hpp"

namespace cs550::pages {
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

/// Arrows of very different lengths, such as the velocities of a bunny at 30 m/s and of the bricks
/// that it has just touched. Typical arrows have the requested length. Far longer ones are cut and
/// dashed.
class Arrows {
 public:
  void add(const Vec3& from, const Vec3& vector) {
    if (from.allFinite() && vector.allFinite()) arrows_.push_back({from, vector});
  }

  /// @param length of a typical arrow (m)
  void draw(Drawing& drawing, Real length, Role role) const {
    const Real usual = usual_norm();
    if (!(usual > 0)) return;
    for (const Arrow& one : arrows_) {
      Vec3 shown = length / usual * one.vector;
      if (shown.norm() < Real(0.05) * length) continue;
      Stroke stroke = arrow(role);
      stroke.dashed = shown.norm() > most * length;
      if (stroke.dashed) shown *= most * length / shown.norm();
      drawing::add_arrow(drawing, one.from, shown, stroke);
    }
  }

 private:
  static constexpr Real most = 2;  ///< typical lengths

  struct Arrow {
    Vec3 from;
    Vec3 vector;
  };

  /// The upper quartile of the lengths above the noise.
  Real usual_norm() const {
    std::vector<Real> norms;
    Real largest = 0;
    for (const Arrow& one : arrows_) largest = std::max(largest, one.vector.norm());
    for (const Arrow& one : arrows_) {
      if (one.vector.norm() > Real(0.05) * largest) norms.push_back(one.vector.norm());
    }
    if (norms.empty()) return 0;
    const auto place = norms.begin() + static_cast<std::ptrdiff_t>(3 * norms.size() / 4);
    std::nth_element(norms.begin(), place, norms.end());
    return *place;
  }

  std::vector<Arrow> arrows_;
};

/// Draws one vector of every dynamic body.
template <class Vector>
void add_vectors(Drawing& drawing, const WorldFrame& frame, Real length, Role role,
                 const Vector& vector) {
  Arrows arrows;
  for_dynamic_bodies(frame,
                     [&](const RigidBody& body) { arrows.add(body.pose.position, vector(body)); });
  arrows.draw(drawing, length, role);
}

/// "A f5 B v2": vertex 2 of B on face 5 of A.
std::string short_name(FeatureId feature) {
  using Kind = FeatureId::Kind;
  const auto names = [&](const char* a, const char* b) {
    return std::string("A ") + a + std::to_string(feature.of_a()) + " B " + b +
           std::to_string(feature.of_b());
  };
  switch (feature.kind()) {
    case Kind::VertexOnFaceA:
    case Kind::CornerOfFaceB:
      return names("f", "v");
    case Kind::VertexOnFaceB:
    case Kind::CornerOfFaceA:
      return names("v", "f");
    case Kind::CrossingOnA:
    case Kind::CrossingOnB:
    case Kind::Edges:
      return names("e", "e");
    case Kind::None:
      break;
  }
  return "";
}

std::size_t count_points(const WorldFrame& frame) {
  std::size_t count = 0;
  for (const Contact& contact : frame.contacts) {
    count += contact.manifold.points.size();
  }
  return count;
}

void add_contacts(Drawing& drawing, const Overlays& overlays, const WorldFrame& frame,
                  Real length) {
  constexpr std::size_t many = 200;
  const Real radius = count_points(frame) > many ? Real(2.2) : Real(4);  // pixels
  Arrows impulses;
  for (const Contact& contact : frame.contacts) {
    const Manifold& manifold = contact.manifold;
    const Pose& pose_a = frame.bodies[contact.body_a].pose;
    const Pose& pose_b = frame.bodies[contact.body_b].pose;
    const Vec3 v = manifold.normal.cross(manifold.tangent);
    for (const ContactPoint& point : manifold.points) {
      const Vec3 place =
          Real(0.5) * (pose_a.to_world(point.anchor_a) + pose_b.to_world(point.anchor_b));
      if (overlays.contacts) {
        drawing.points.push_back({place, Role::Got, radius});
        drawing::add_arrow(drawing, place, length * manifold.normal, arrow(Role::Axis));
      }
      if (overlays.impulses) {
        impulses.add(place, point.normal_impulse * manifold.normal +
                                point.tangent_impulse.x() * manifold.tangent +
                                point.tangent_impulse.y() * v);
      }
      if (overlays.feature_ids) {
        drawing.labels.push_back({place, short_name(point.feature), Role::Text});
      }
    }
  }
  impulses.draw(drawing, 2 * length, Role::Expected);
}

void add_legend(Drawing& drawing, const Overlays& overlays) {
  const auto add = [&](bool wanted, const char* text, const Stroke& stroke) {
    if (wanted) drawing.legend.push_back({text, stroke});
  };
  const auto add_dot = [&](bool wanted, const char* text, Role role) {
    if (wanted) drawing.legend.push_back({text, thin(role), drawing::LegendMark::Dot});
  };
  add_dot(overlays.contacts, "contact point", Role::Got);
  add(overlays.contacts, "contact normal, A to B", arrow(Role::Axis));
  add(overlays.impulses, "impulse on B", arrow(Role::Expected));
  add(overlays.bounds, "bounds of a body", thin(Role::BodyA));
  add(overlays.tree, "node of the tree", thin(Role::Incident));
  add(overlays.velocities, "velocity", arrow(Role::BodyA));
  add(overlays.spins, "angular velocity", arrow(Role::Incident));
  add(overlays.momenta, "linear momentum", arrow(Role::Reference));
  add(overlays.momenta, "angular momentum", arrow(Role::Got));
  add_dot(overlays.centers, "centre of mass", Role::Axis);
  if (overlays.feature_ids) {
    drawing.notes.push_back("A f5 B v2: vertex 2 of B on face 5 of A; e: edge.");
  }
  const bool are_cut = std::any_of(
      drawing.lines.begin(), drawing.lines.end(),
      [](const drawing::Line& line) { return line.stroke.dashed && line.stroke.arrow; });
  if (are_cut) drawing.notes.push_back("Dashed arrows are drawn shorter than they are.");
}

}  // namespace

void describe(Overlays& overlays, ControlVisitor& visit) {
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
      add_edges(drawing, *meshes[mesh], frame.bodies[i].pose, thin(Role::Axis));
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
    add_vectors(drawing, frame, 3 * length, Role::BodyA,
                [](const RigidBody& body) { return body.linear_velocity; });
  }
  if (overlays.spins) {
    add_vectors(drawing, frame, 3 * length, Role::Incident,
                [](const RigidBody& body) { return body.angular_velocity; });
  }
  if (overlays.momenta) {
    add_vectors(drawing, frame, 3 * length, Role::Reference,
                [](const RigidBody& body) { return body.linear_momentum; });
    add_vectors(drawing, frame, 3 * length, Role::Got,
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

}  // namespace cs550::pages
