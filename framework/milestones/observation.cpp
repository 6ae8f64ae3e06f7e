#include "observation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "cs550/clipping.hpp"
#include "cs550/diagnostics.hpp"
#include "cs550/hill_climbing.hpp"

namespace cs550::milestones {
namespace {

// Two correct engines differ by rounding and by the order of their sums. The error of a wrong
// formula is a hundred times larger within seconds.
constexpr double length_tolerance = 0.05;  // m; a body is about half a metre
constexpr double angle_tolerance = 0.15;   // rad

std::vector<double> numbers(const Vec3& vector) {
  return {static_cast<double>(vector.x()), static_cast<double>(vector.y()),
          static_cast<double>(vector.z())};
}

std::vector<double> numbers(const Quat& q) {
  return {static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
          static_cast<double>(q.z())};
}

PosedShape posed_shape(const World& world, std::size_t body) {
  return world.posed_shape(world.id_at(static_cast<Index>(body)));
}

std::string pair_name(const Scene& scene, std::size_t a, std::size_t b) {
  return scene.body_names[a] + " and " + scene.body_names[b];
}

void append_pose(const std::string& name, const Pose& pose, Observation& seen) {
  seen.push_back({name + ": position", "m", numbers(pose.position), length_tolerance});
  seen.push_back({name + ": orientation", "rad", numbers(pose.orientation), angle_tolerance});
}

/// Calls visit(a, b) with the indices of every pair of bodies unless both are static.
void for_each_pair(const Scene& scene, const std::function<void(std::size_t, std::size_t)>& visit) {
  const auto is_static = [&](std::size_t i) { return scene.bodies[i].kind == BodyKind::Static; };
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      if (!is_static(a) || !is_static(b)) visit(a, b);
    }
  }
}

/// The mean of points in the world; the origin when there are none.
Vec3 middle(const Manifold& manifold, const Pose& pose_of_a) {
  Vec3 sum = Vec3::Zero();
  for (const ContactPoint& point : manifold.points) sum += pose_of_a.to_world(point.anchor_a);
  return manifold.points.empty() ? sum : Vec3(sum / static_cast<Real>(manifold.points.size()));
}

double depth(const Manifold& manifold) {
  Real deepest = 0;
  for (const ContactPoint& point : manifold.points) deepest = std::max(deepest, -point.separation);
  return static_cast<double>(deepest);
}

/// Whether a body is where it started, within the effects of settling and rounding.
bool still_stands(const RigidBody& body, const BodyDef& start) {
  const Real room = start.shape->smallest_half_extent / 2;
  constexpr Real ten_degrees = pi / 18;
  return (body.pose.position - start.pose.position).norm() < room &&
         body.pose.orientation.angularDistance(start.pose.orientation) < ten_degrees;
}

}  // namespace

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    sum += (a[i] + b[i]) * (a[i] + b[i]);
  }
  if (a.size() != 4) return std::sqrt(difference);
  // q and -q are the same orientation; |q - p| = 2 sin(angle / 4). std::min would replace a NaN by
  // its other argument.
  if (std::isnan(difference)) return difference;
  return 4 * std::asin(std::min(1.0, std::sqrt(std::min(difference, sum)) / 2));
}

Observation poses(const World& world, const Scene& scene) {
  Observation seen;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].kind == BodyKind::Static) continue;
    append_pose(scene.body_names[i], world.bodies()[i].pose, seen);
  }
  return seen;
}

Observation meshes_and_poses(const World& world, const Scene& scene) {
  Observation seen;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const HalfEdgeMesh& mesh = scene.bodies[i].shape->mesh;
    seen.push_back(
        {scene.body_names[i] + ": vertices, edges and faces",
         "elements",
         {static_cast<double>(mesh.vertex_count()), static_cast<double>(mesh.edge_count()) / 2,
          static_cast<double>(mesh.face_count())},
         0.5});
  }
  const Observation where = poses(world, scene);
  seen.insert(seen.end(), where.begin(), where.end());
  return seen;
}

Observation lowest_points(const World& world, const Scene& scene) {
  Observation seen;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SupportPoint lowest = support(posed_shape(world, i), -Vec3::UnitZ());
    seen.push_back({scene.body_names[i] + ": height of its lowest point",
                    "m",
                    {static_cast<double>(lowest.point.z())},
                    length_tolerance});
  }
  return seen;
}

Observation separations(const World& world, const Scene& scene) {
  Observation seen;
  for_each_pair(scene, [&](std::size_t a, std::size_t b) {
    const SeparatingAxis found =
        find_separating_axis(posed_shape(world, a), posed_shape(world, b), {}, HUGE_VALF);
    seen.push_back({pair_name(scene, a, b) + ": separation",
                    "m",
                    {static_cast<double>(found.separation)},
                    length_tolerance});
  });
  return seen;
}

Observation contact_patches(const World& world, const Scene& scene) {
  constexpr double millimetre = 0.001;  // the depths are a few of them
  Observation seen;
  for_each_pair(scene, [&](std::size_t a, std::size_t b) {
    const PosedShape shape_a = posed_shape(world, a);
    const PosedShape shape_b = posed_shape(world, b);
    const SeparatingAxis axis = find_separating_axis(shape_a, shape_b, {}, 0);
    const Manifold manifold =
        axis.separation < 0 ? build_manifold(shape_a, shape_b, axis, 0) : Manifold{};
    const std::string name = pair_name(scene, a, b);
    const auto count = static_cast<double>(manifold.points.size());
    seen.push_back({name + ": contact points", "points", {count}, 0.5});
    seen.push_back({name + ": middle of the contact points", "m",
                    numbers(middle(manifold, shape_a.pose)), length_tolerance});
    seen.push_back({name + ": depth", "m", {depth(manifold)}, millimetre});
  });
  return seen;
}

Observation heap(const World& world, const Scene& scene) {
  constexpr double share_of_energy = 0.05;
  constexpr double share_of_bodies = 0.05;
  const Real substep = scene.h / static_cast<Real>(scene.settings.substeps);
  double height = 0;
  int dynamic = 0;
  int standing = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].kind != BodyKind::Dynamic) continue;
    const RigidBody& body = world.bodies()[i];
    height += static_cast<double>(body.pose.position.z());
    dynamic += 1;
    standing += still_stands(body, scene.bodies[i]) ? 1 : 0;
  }
  const double energy_at_start = energy(make_world(scene), substep).total();
  return {{"energy", "J", {energy(world, substep).total()}, share_of_energy * energy_at_start},
          {"mean height", "m", {height / dynamic}, length_tolerance},
          {"bodies that stand where they began",
           "bodies",
           {static_cast<double>(standing)},
           share_of_bodies * dynamic}};
}

}  // namespace cs550::milestones
