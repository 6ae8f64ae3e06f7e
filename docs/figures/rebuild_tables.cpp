// What the engine answers, for the scripts in docs/rebuild, which compute it again from the book's text.
#include <array>
#include <cmath>

#include "cs550/clipping.hpp"
#include "cs550/separating_axis.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

std::ostream& operator<<(std::ostream& out, const Quat& q) {
  return out << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z();
}

std::ostream& write(std::ostream& out, const Vec3& v) {
  return out << v.x() << ' ' << v.y() << ' ' << v.z();
}

constexpr Real manifold_margin = Real(0.05);  // m

/// the kind of the reference feature, the normal, the number of points; per point, up to four, the points on A and on
/// B in the world and the kind of the feature
void write_manifold(std::ostream& out, const Manifold& manifold, const Pose& a, const Pose& b) {
  out << static_cast<int>(manifold.reference) << ' ';
  write(out, manifold.normal) << ' ' << manifold.points.size();
  for (int i = 0; i < max_manifold_points; ++i) {
    const ContactPoint point = i < manifold.points.size() ? manifold.points[i] : ContactPoint{};
    write(out << ' ', a.to_world(point.anchor_a));
    write(out << ' ', b.to_world(point.anchor_b)) << ' ' << static_cast<int>(point.feature.kind());
  }
}

/// per pair of boxes: half-extents, position and orientation (w x y z) of A, the same of B; then the kind of
/// the features (1 face of A, 2 face of B, 3 edges), the axis, the separation, and the manifold
void rebuild_boxes(std::ostream& out) {
  constexpr int pairs = 400;
  Sequence random(23);
  const auto length = [&] { return static_cast<Real>(0.2 + random.next()); };
  for (int i = 0; i < pairs; ++i) {
    std::array<Vec3, 2> halves;
    for (Vec3& half : halves) half = {length(), length(), length()};
    const ShapePtr a = box(halves[0]), b = box(halves[1]);
    const auto distance = static_cast<Real>(2 * random.next());
    const Vec3 apart = distance * random.direction();
    const std::array<PosedShape, 2> bodies{
        PosedShape{a.get(), {random.direction(), random.orientation()}},
        PosedShape{b.get(), {apart, random.orientation()}}};
    const SeparatingAxis found = find_separating_axis(bodies[0], bodies[1], {}, HUGE_VALF);
    for (std::size_t k = 0; k < 2; ++k) {
      write(out, halves.at(k)) << ' ';
      write(out, bodies.at(k).pose.position) << ' ' << bodies.at(k).pose.orientation << ' ';
    }
    out << static_cast<int>(found.feature) << ' ';
    write(out, found.axis) << ' ' << found.separation << ' ';
    const Manifold manifold = build_manifold(bodies[0], bodies[1], found, manifold_margin);
    write_manifold(out, manifold, bodies[0].pose, bodies[1].pose);
    out << '\n';
  }
}

}  // namespace

std::vector<Table> rebuild_tables() { return {{"rebuild_boxes", rebuild_boxes}}; }

}  // namespace cs550::book
