#include "body_order.hpp"

#include <algorithm>
#include <numeric>

namespace cs550::live {

namespace {

/// Bodies in contact overlap a little: a plane separates them if no vertex is deeper than this.
constexpr Real overlap_share = Real(0.1);  ///< of the body's radius

/// A body on the canvas.
struct Seen {
  const pages::Solid* solid;
  Vec3 center;    ///< world (m)
  Real radius;    ///< of a ball about the centre (m)
  Real distance;  ///< from the eye to the centre (m)
  Vec2 least;     ///< pixels
  Vec2 most;      ///< pixels
};

Seen look_at(const pages::Solid& solid, const pages::Projection& seen) {
  constexpr Real everywhere = Real(1e9);  // pixels
  Bounds bounds;
  for (const Vec3& vertex : solid.mesh->vertices) bounds.include(solid.pose.to_world(vertex));
  Seen body{&solid,
            bounds.center(),
            Real(0.5) * bounds.extent().norm(),
            0,
            Vec2::Constant(everywhere),
            Vec2::Constant(-everywhere)};
  body.distance = (body.center - seen.eye()).norm();
  for (const Vec3& vertex : solid.mesh->vertices) {
    const Vec3 point = solid.pose.to_world(vertex);
    if (!seen.is_in_front(point)) {  // the body surrounds the camera's plane
      body.least = Vec2::Constant(-everywhere);
      body.most = Vec2::Constant(everywhere);
      break;
    }
    body.least = body.least.cwiseMin(seen.pixel(point));
    body.most = body.most.cwiseMax(seen.pixel(point));
  }
  return body;
}

bool overlap(const Seen& a, const Seen& b) {
  return (a.least.array() < b.most.array()).all() && (b.least.array() < a.most.array()).all();
}

enum class Order { AFirst, BFirst, Unknown };

/// By the face of a that is farthest below the centre of b: if all of b is above its plane, b can hide a
/// only from an eye above it, and a can hide b only from an eye below it.
Order order_by_face(const Seen& a, const Seen& b, const Vec3& eye) {
  const Pose& pose = a.solid->pose;
  const Vec3 center = pose.to_body(b.center);
  const auto& faces = a.solid->mesh->faces;
  const auto best =
      std::max_element(faces.begin(), faces.end(), [&](const Face& first, const Face& second) {
        return first.plane.distance(center) < second.plane.distance(center);
      });
  Real lowest = best->plane.distance(center);
  for (const Vec3& vertex : b.solid->mesh->vertices) {
    lowest = std::min(lowest, best->plane.distance(pose.to_body(b.solid->pose.to_world(vertex))));
  }
  if (lowest < -overlap_share * std::min(a.radius, b.radius)) return Order::Unknown;
  return best->plane.distance(pose.to_body(eye)) > 0 ? Order::AFirst : Order::BFirst;
}

/// Whether a is painted before b. @pre they overlap on the canvas
bool is_first(const Seen& a, const Seen& b, const Vec3& eye) {
  Order order = order_by_face(a, b, eye);
  if (order != Order::Unknown) return order == Order::AFirst;
  order = order_by_face(b, a, eye);
  if (order != Order::Unknown) return order == Order::BFirst;
  return a.distance > b.distance;
}

/// Visits bodies in depth-first order, each after all that it may hide.
class Painter {
 public:
  explicit Painter(std::vector<std::vector<std::size_t>> before)
      : before_(std::move(before)), visited_(before_.size(), false) {}

  void visit(std::size_t body) {
    if (visited_[body]) return;
    visited_[body] = true;
    for (const std::size_t other : before_[body]) visit(other);
    order.push_back(body);
  }

  std::vector<std::size_t> order;

 private:
  std::vector<std::vector<std::size_t>> before_;
  std::vector<bool> visited_;
};

/// For each body those that are painted before it, found by a sweep from left to right.
std::vector<std::vector<std::size_t>> painted_before(const std::vector<Seen>& bodies,
                                                     const Vec3& eye) {
  std::vector<std::size_t> by_left(bodies.size());
  std::iota(by_left.begin(), by_left.end(), std::size_t{0});
  std::sort(by_left.begin(), by_left.end(), [&](std::size_t a, std::size_t b) {
    return bodies[a].least.x() < bodies[b].least.x();
  });
  std::vector<std::vector<std::size_t>> before(bodies.size());
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    const Seen& a = bodies[by_left[i]];
    for (std::size_t j = i + 1; j < by_left.size(); ++j) {
      const Seen& b = bodies[by_left[j]];
      if (b.least.x() >= a.most.x()) break;
      if (!overlap(a, b)) continue;
      const bool a_first = is_first(a, b, eye);
      before[by_left[a_first ? j : i]].push_back(by_left[a_first ? i : j]);
    }
  }
  return before;
}

}  // namespace

std::vector<std::size_t> back_to_front(const std::vector<pages::Solid>& solids,
                                       const pages::Projection& seen) {
  std::vector<Seen> bodies;
  bodies.reserve(solids.size());
  for (const pages::Solid& solid : solids) bodies.push_back(look_at(solid, seen));
  std::vector<std::size_t> far_to_near(bodies.size());
  std::iota(far_to_near.begin(), far_to_near.end(), std::size_t{0});
  std::sort(far_to_near.begin(), far_to_near.end(),
            [&](std::size_t a, std::size_t b) { return bodies[a].distance > bodies[b].distance; });
  Painter painter(painted_before(bodies, seen.eye()));
  for (const std::size_t body : far_to_near) painter.visit(body);
  return painter.order;
}

}  // namespace cs550::live
