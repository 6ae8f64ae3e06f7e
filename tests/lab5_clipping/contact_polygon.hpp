#pragma once
/// @file contact_polygon.hpp
/// The incident face clipped to the reference face, by testing all candidate corners.

#include <algorithm>
#include <vector>

#include "lab5_clipping/contacts.hpp"

namespace cs550::test {

/// In double precision and without clipping: all pairs of bounding lines (of the incident face and
/// of the side planes) are intersected in the plane of the incident face. The intersections inside
/// all of them are the corners.
struct ContactPolygon {
  std::vector<Point> corners;  ///< those below the reference plane, world frame
  bool ambiguous = false;      ///< whether rounding could change the incident face or a corner
  double tolerance = 0;        ///< m

  ContactPolygon(const PosedShape& owner, const FaceQuery& query, const PosedShape& other) {
    const Index reference_face = query.face;
    const double size = static_cast<double>(std::min(owner.shape->radius, other.shape->radius));
    const double blur = 5 * static_cast<double>(side_plane_tolerance) * size;
    const HalfPlane reference = plane_of(owner, reference_face);

    // The most anti-parallel face at the deepest vertex, and whether another one is almost as anti-parallel.
    Index incident_face = 0;
    double smallest = 2;
    for (const Index f : faces_at(other.mesh(), query.vertex)) {
      const double cosine = plane_of(other, f).normal.dot(reference.normal);
      ambiguous |= std::abs(cosine - smallest) < 1e-4;
      if (cosine < smallest) {
        smallest = cosine;
        incident_face = f;
      }
    }
    const HalfPlane incident = plane_of(other, incident_face);

    std::vector<HalfPlane> sides;
    add_sides(sides, owner, reference_face, reference.normal,
              static_cast<double>(side_plane_tolerance) * size);
    add_sides(sides, other, incident_face, incident.normal, 0);

    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        Eigen::Matrix3d normals;
        normals << sides[i].normal.transpose(), sides[j].normal.transpose(),
            incident.normal.transpose();
        const double determinant = normals.determinant();
        if (std::abs(determinant) < 1e-9) continue;
        const Point corner =
            normals.inverse() * Point(sides[i].offset, sides[j].offset, incident.offset);
        double worst = -HUGE_VAL;
        for (std::size_t k = 0; k < sides.size(); ++k) {
          if (k != i && k != j) worst = std::max(worst, sides[k].distance(corner));
        }
        if (worst > blur) continue;
        const double height = reference.distance(corner);
        ambiguous |= worst > -blur || std::abs(height) < blur || std::abs(determinant) < 0.05;
        if (height <= 0) corners.push_back(corner);
      }
    }
    // Rounding of float, magnified where two lines meet at a small angle (sine above 0.05).
    tolerance = 2e-4 * size;
  }

  double distance_to_nearest_corner(const Point& point) const {
    double nearest = HUGE_VAL;
    for (const Point& corner : corners) nearest = std::min(nearest, (corner - point).norm());
    return nearest;
  }

 private:
  struct HalfPlane {
    Point normal;
    double offset;
    double distance(const Point& point) const { return normal.dot(point) - offset; }
  };

  static HalfPlane plane_of(const PosedShape& body, Index face) {
    const Point normal = body.pose.orientation.cast<double>().normalized() *
                         body.mesh().face(face).plane.normal.cast<double>().normalized();
    const Index vertex = body.mesh().edge(body.mesh().face(face).edge).vertex;
    return {normal, normal.dot(in_world(body, body.mesh().vertex(vertex)))};
  }

  static void add_sides(std::vector<HalfPlane>& sides, const PosedShape& body, Index face,
                        const Point& face_normal, double outward) {
    const HalfEdgeMesh& mesh = body.mesh();
    for (const Index e : face_edges(mesh, face)) {
      const Point from = in_world(body, mesh.vertex(mesh.origin(e)));
      const Point to = in_world(body, mesh.vertex(mesh.edge(e).vertex));
      const Point normal = (to - from).cross(face_normal).normalized();
      sides.push_back({normal, normal.dot(from) + outward});
    }
  }
};

}  // namespace cs550::test
