#include "engine/contacts/loaded_points.hpp"

#include <algorithm>

#include "engine/pairs/relative_pose.hpp"
#include "engine/pairs/temporal_coherence.hpp"

namespace cs550 {

namespace {

/// Points that are closer to each other, relative to the smaller radius, hold a body like a single one.
/// The new one may be the old one under another name, after it slid over an edge.
constexpr Real distinct_distance = Real(0.05);

bool has_feature(const Manifold& manifold, FeatureId feature) {
  return std::any_of(manifold.points.begin(), manifold.points.end(),
                     [&](const ContactPoint& point) { return point.feature == feature; });
}

using Points = StaticVector<ContactPoint, max_manifold_points>;

Points loaded_points_without_successor(const Manifold& before, const Manifold& now) {
  Points lost;
  for (const ContactPoint& point : before.points) {
    if (point.normal_impulse > 0 && !has_feature(now, point.feature)) lost.push_back(point);
  }
  return lost;
}

/// The plane of a manifold, in the frame of the body that owns the reference face. The other body is
/// the incident one.
class ContactPlane {
 public:
  /// @pre the manifold has points and a reference face
  ContactPlane(const PosedShape& a, const PosedShape& b, const Manifold& manifold)
      : on_b_(manifold.reference == AxisFeature::FaceB),
        on_owner_(on_b_ ? &ContactPoint::anchor_b : &ContactPoint::anchor_a),
        on_incident_(on_b_ ? &ContactPoint::anchor_a : &ContactPoint::anchor_b),
        owner_(on_b_ ? b : a),
        incident_in_owner_(seen_from(owner_.pose, on_b_ ? a.pose : b.pose)),
        radius_(std::min(a.shape->radius, b.shape->radius)) {
    plane_.normal = owner_.pose.unrotate(on_b_ ? Vec3(-manifold.normal) : manifold.normal);
    plane_.offset = plane_.normal.dot(manifold.points[0].*on_owner_);
  }

  /// The point with its anchor on the owner in the plane, and its separation from there.
  ContactPoint projected(ContactPoint point) const {
    const Vec3 corner = incident_in_owner_.to_world(point.*on_incident_);
    point.separation = plane_.distance(corner);
    point.*on_owner_ = corner - point.separation * plane_.normal;
    return point;
  }

  /// Whether the point's anchor on the incident body is inside the owner, or as close to it as the
  /// points of a kept manifold.
  bool is_inside_owner(const ContactPoint& point) const {
    const Vec3 corner = incident_in_owner_.to_world(point.*on_incident_);
    const auto& faces = owner_.mesh().faces;
    return std::all_of(faces.begin(), faces.end(), [&](const Face& face) {
      return face.plane.distance(corner) <= kept_motion * radius_;
    });
  }

  bool are_distinct(const ContactPoint& p, const ContactPoint& q) const {
    return (p.*on_incident_ - q.*on_incident_).norm() > distinct_distance * radius_;
  }

 private:
  bool on_b_;
  Vec3 ContactPoint::*on_owner_;
  Vec3 ContactPoint::*on_incident_;
  const PosedShape& owner_;
  Pose incident_in_owner_;
  Real radius_;
  Plane plane_;
};

/// Adds a point, if need be in the place of the one with the widest gap.
void add_point(Points& points, const ContactPoint& point, Real reach) {
  if (points.size() < max_manifold_points) return points.push_back(point);
  auto* widest = std::max_element(
      points.begin(), points.end(),
      [](const ContactPoint& p, const ContactPoint& q) { return p.separation < q.separation; });
  if (widest->separation > reach) *widest = point;
}

}  // namespace

void keep_loaded_points(const PosedShape& a, const PosedShape& b, const Manifold& before,
                        Real reach, Manifold& now) {
  const bool same_owner = now.reference == before.reference && now.reference != AxisFeature::Edges;
  if (!same_owner || now.points.empty()) return;
  const Points lost = loaded_points_without_successor(before, now);
  if (lost.empty()) return;

  const ContactPlane plane(a, b, now);
  for (const ContactPoint& old : lost) {
    const ContactPoint point = plane.projected(old);
    const bool is_apart =
        std::all_of(now.points.begin(), now.points.end(),
                    [&](const ContactPoint& other) { return plane.are_distinct(point, other); });
    const bool touches = point.separation <= 0 && plane.is_inside_owner(point);
    if (is_apart && touches) add_point(now.points, point, reach);
  }
}

}  // namespace cs550
