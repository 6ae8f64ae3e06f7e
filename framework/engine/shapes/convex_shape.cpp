#include "cs550/convex_shape.hpp"

#include <algorithm>
#include <optional>

#include "cs550/mass_properties.hpp"
#include "cs550/mesh_validation.hpp"

namespace cs550 {
namespace {

Index face_vertex_count(const HalfEdgeMesh& mesh, Index f) {
  Index count = 0;
  for ([[maybe_unused]] Index e : face_edges(mesh, f)) ++count;
  return count;
}

bool has_too_many_edges(const HalfEdgeMesh& mesh) {
  return mesh.edge_count() / 2 > max_shape_edges;
}

/// Why the engine cannot hold a valid mesh, if it cannot.
std::optional<std::string> face_beyond_limit(const HalfEdgeMesh& mesh) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index count = face_vertex_count(mesh, f);
    if (count > max_face_vertices) {
      return "face " + std::to_string(f) + " has " + std::to_string(count) +
             " vertices and a face of a shape at most " + std::to_string(max_face_vertices) +
             ": take fewer points around it";
    }
  }
  return std::nullopt;
}

void move_origin_to(const Vec3& origin, HalfEdgeMesh& mesh) {
  for (Vec3& vertex : mesh.vertices) vertex -= origin;
  for (Face& face : mesh.faces) {
    // From the moved vertices: subtracting from the old offset would lose digits far from the origin.
    Real sum = 0;
    Index count = 0;
    for (Index e = face.edge; count == 0 || e != face.edge; e = mesh.edge(e).next, ++count) {
      sum += face.plane.normal.dot(mesh.vertex(mesh.edge(e).vertex));
    }
    face.plane.offset = sum / static_cast<Real>(count);
  }
}

std::vector<PlaneBlock> plane_blocks_of(const HalfEdgeMesh& mesh) {
  constexpr Index four = 4;
  std::vector<PlaneBlock> blocks;
  for (Index first = 0; first < mesh.face_count(); first += four) {
    PlaneBlock& block = blocks.emplace_back();
    for (Index lane = 0; lane < four; ++lane) {
      const Plane& plane = mesh.face(std::min(first + lane, mesh.face_count() - 1)).plane;
      block.x[lane] = plane.normal.x();
      block.y[lane] = plane.normal.y();
      block.z[lane] = plane.normal.z();
      block.offset[lane] = plane.offset;
    }
  }
  return blocks;
}

/// The distance between the plane of a face and the farthest vertex behind it.
Real width_behind(const Plane& plane, const HalfEdgeMesh& mesh) {
  Real width = 0;
  for (const Vec3& vertex : mesh.vertices) width = std::max(width, -plane.distance(vertex));
  return width;
}

void measure(ConvexShape& shape) {
  for (const Vec3& vertex : shape.mesh.vertices) {
    shape.bounds.include(vertex);
    shape.radius = std::max(shape.radius, vertex.norm());
  }
  Real smallest_width = HUGE_VALF;
  shape.inner_radius = HUGE_VALF;
  for (const Face& face : shape.mesh.faces) {
    shape.inner_radius = std::min(shape.inner_radius, face.plane.offset);
    smallest_width = std::min(smallest_width, width_behind(face.plane, shape.mesh));
  }
  shape.smallest_half_extent = smallest_width / 2;
}

/// Distances below this part of the largest extent are rounding of the vertices.
constexpr Real vertex_rounding = Real(3e-7);

/// The largest slope of an edge against the plane of a face beside it, beyond rounding.
/// @pre validate() accepts the mesh
Real steepest_edge(const HalfEdgeMesh& mesh) {
  Bounds bounds;
  for (const Vec3& vertex : mesh.vertices) bounds.include(vertex);
  const Real allowed = vertex_rounding * bounds.extent().maxCoeff();
  Real steepest = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Vec3 along = mesh.edge_vector(e);
    const Real rise = std::abs(mesh.face(mesh.edge(e).face).plane.normal.dot(along));
    steepest = std::max(steepest, (rise - allowed) / along.norm());
  }
  return steepest;
}

/// The part of the volume that merging must keep. A mesh that is thinner than the tolerance collapses.
constexpr Real least_volume_kept = Real(0.9);

/// Merges faces with the largest tolerance that leaves no edge steeper than max_edge_slope, else with the
/// one that leaves the flattest edges. The tolerance is relative to the whole mesh: on a thin one it also
/// unites narrow faces that enclose an angle. Their edges are then not perpendicular to the common normal,
/// and the arcs of lab 4 rely on that. A tolerance that loses volume is not taken. Nothing if all do.
std::optional<HalfEdgeMesh> with_flat_faces(const HalfEdgeMesh& mesh) {
  HalfEdgeMesh best = merge_coplanar_faces(mesh, coplanar_tolerance);
  // Refused as it is. To validate it may take minutes if it has too many edges.
  if (has_too_many_edges(best) || validate(best)) return best;
  const Real least_volume = least_volume_kept * mass_properties(mesh).volume;
  const auto steepness = [&](const HalfEdgeMesh& merged) {
    return mass_properties(merged).volume < least_volume ? HUGE_VALF : steepest_edge(merged);
  };
  Real least = steepness(best);
  for (const Real tolerance : {coplanar_tolerance / 10, vertex_rounding}) {
    if (least <= max_edge_slope) break;
    HalfEdgeMesh merged = merge_coplanar_faces(mesh, tolerance);
    if (validate(merged)) continue;
    const Real steepest = steepness(merged);
    if (steepest >= least) continue;
    least = steepest;
    best = std::move(merged);
  }
  if (least == HUGE_VALF) return std::nullopt;
  return best;
}

}  // namespace

ShapeResult make_shape(const HalfEdgeMesh& mesh) {
  if (has_too_many_edges(mesh)) {
    return {nullptr, "the mesh has " + std::to_string(mesh.edge_count() / 2) +
                         " edges and a shape at most " + std::to_string(max_shape_edges) +
                         ": take fewer points"};
  }
  if (const auto defect = validate(mesh)) {
    return {nullptr, defect->sentence + "; mend the mesh, or use the convex hull of its vertices"};
  }
  if (const auto error = face_beyond_limit(mesh)) return {nullptr, *error};

  const MassProperties properties = mass_properties(mesh);
  auto shape = std::make_shared<ConvexShape>();
  shape->mesh = mesh;
  shape->volume = properties.volume;
  shape->unit_inertia = properties.unit_inertia;
  shape->source_origin = -properties.centroid;
  move_origin_to(properties.centroid, shape->mesh);
  shape->plane_blocks = plane_blocks_of(shape->mesh);
  measure(*shape);
  return {std::move(shape), {}};
}

ShapeResult make_shape(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
  const MeshBuild build = build_half_edge_mesh(vertices, triangles);
  if (build.issue) {
    return {nullptr, describe(build.issue) + "; or use the convex hull of the vertices"};
  }
  const std::optional<HalfEdgeMesh> merged = with_flat_faces(build.mesh);
  if (!merged) {
    return {nullptr,
            "the mesh is too thin: merging its faces removes more than a tenth of its volume; "
            "make it thicker than a millionth of its length"};
  }
  return make_shape(*merged);
}

Vec3 PosedShape::vertex(Index v) const { return pose.to_world(mesh().vertex(v)); }

Plane PosedShape::plane(Index f) const {
  const Plane& local = mesh().face(f).plane;
  const Vec3 normal = pose.rotate(local.normal);
  return {normal, local.offset + normal.dot(pose.position)};
}

Bounds world_bounds(const PosedShape& body) {
  const ConvexShape& shape = *body.shape;
  const Vec3 center = body.pose.to_world(shape.bounds.center());
  const Vec3 half = body.pose.rotation().cwiseAbs() * (shape.bounds.extent() / 2);
  // The turned box is tight for boxes, the sphere for round shapes: both hold all of the body.
  const Vec3 reach = Vec3::Constant(shape.radius);
  return {(center - half).cwiseMax(body.pose.position - reach),
          (center + half).cwiseMin(body.pose.position + reach)};
}

}  // namespace cs550
