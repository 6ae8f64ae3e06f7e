#include "benchmarks/quality/quality.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "benchmarks/quality/hull_overlap.hpp"

namespace cs550::bench {
namespace {

using Eigen::Vector3d;

constexpr double deep = 0.02;
/// How far a body may be outside the room, or below the floor (m).
constexpr double outside = 0.5;

bool is_lost(const BenchScene& scene, const BodyMotion& motion) {
  const Vector3d& x = motion.position;
  const double reach = static_cast<double>(scene.half_width) + outside;
  const bool is_finite = x.allFinite() && motion.orientation.coeffs().allFinite() &&
                         motion.velocity.allFinite() && motion.angular_velocity.allFinite();
  return !is_finite || std::abs(x.x()) > reach || std::abs(x.y()) > reach || x.z() < -outside;
}

/// ½·m·v² + ½·ω·I·ω
double kinetic_energy(const BodyDef& body, const BodyMotion& motion) {
  const double density = static_cast<double>(body.density);
  const Vector3d turning = motion.orientation.conjugate() * motion.angular_velocity;
  const Eigen::Matrix3d unit_inertia = body.shape->unit_inertia.cast<double>();
  return density / 2 *
         (static_cast<double>(body.shape->volume) * motion.velocity.squaredNorm() +
          turning.dot(unit_inertia * turning));
}

double sideways(const BodyDef& body, const BodyMotion& motion) {
  return (motion.position - body.pose.position.cast<double>()).head<2>().norm();
}

struct PlacedBody {
  PlacedHull hull;
  bool is_static;
};

/// Sorted along x, so that a body is compared only with those that begin before it ends.
void measure_penetration(std::vector<PlacedBody>& bodies, Quality& quality) {
  std::sort(bodies.begin(), bodies.end(), [](const PlacedBody& a, const PlacedBody& b) {
    return a.hull.lower.x() < b.hull.lower.x();
  });
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const PlacedBody& a = bodies[i];
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const PlacedBody& b = bodies[j];
      if (b.hull.lower.x() > a.hull.upper.x()) break;
      if ((a.is_static && b.is_static) || !bounds_overlap(a.hull, b.hull)) continue;
      const double depth = penetration_depth(a.hull, b.hull);
      quality.deepest = std::max(quality.deepest, depth);
      if (depth > deep) ++quality.deep_pairs;
    }
  }
}

}  // namespace

Quality evaluate(const BenchScene& scene, std::span<const BodyMotion> motions) {
  Quality quality;
  if (scene.stays_upright) quality.drift = 0;
  std::vector<PlacedBody> placed;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    const bool is_static = body.kind == BodyKind::Static;
    if (!is_static && is_lost(scene, motions[i])) {
      ++quality.lost_bodies;
      continue;
    }
    placed.push_back({PlacedHull(*body.shape, motions[i]), is_static});
    if (is_static) continue;
    quality.kinetic_energy += kinetic_energy(body, motions[i]);
    if (quality.drift) quality.drift = std::max(*quality.drift, sideways(body, motions[i]));
  }
  measure_penetration(placed, quality);
  return quality;
}

}  // namespace cs550::bench
