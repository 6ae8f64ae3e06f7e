#pragma once
/// @file pictures.hpp
/// Pictures of failed tests of lab 5.

#include <string>
#include <vector>

#include "drawing/clip_drawing.hpp"
#include "drawing/manifold_drawing.hpp"
#include "drawing/mesh_drawing.hpp"
#include "helpers/picture.hpp"
#include "lab5_clipping/polygons.hpp"

namespace cs550::test {

/// A view in which a direction points up on the page.
inline drawing::View seen_from_the_side(const Vec3& upward) {
  drawing::View view;
  if (!(upward.norm() > 0)) return view;
  view.up = upward.normalized();
  view.toward_eye = any_perpendicular(view.up) + Real(0.4) * view.up;
  return view;
}

/// The expected polygon after a clip beside the actual one, seen along its normal.
inline std::string clip_picture(const ClipPolygon& before, const Plane& plane,
                                const std::vector<Vec3>& expected, const ClipPolygon& got) {
  drawing::View flat = drawing::view_from_above();
  const std::vector<Vec3> corners = drawing::corners(before);
  flat.toward_eye = drawing::polygon_normal(corners);
  return expected_beside_got(
      "A polygon clipped by a plane",
      drawing::draw_clip(before, plane, polygon_of(expected), drawing::Role::Expected),
      drawing::draw_clip(before, plane, got, drawing::Role::Got), flat,
      "Numbers: the order of the corners, counter-clockwise.");
}

/// The expected points of a manifold beside the actual ones, half-way between their anchors.
inline std::string contact_picture(const PosedShape& a, const PosedShape& b,
                                   const std::vector<Vec3>& expected, const Manifold& got) {
  drawing::Drawing wanted = drawing::draw_contact(a, b, {}, drawing::Role::Expected);
  for (const Vec3& point : expected) {
    wanted.points.push_back({point, drawing::Role::Expected, Real(5.5)});
  }
  wanted.title = std::to_string(expected.size()) + " contact points";
  const Vec3 upward = b.pose.position - a.pose.position;
  return expected_beside_got("Contact points, B above A", wanted,
                             drawing::draw_contact(a, b, got, drawing::Role::Got),
                             seen_from_the_side(upward));
}

/// A wrong manifold, seen perpendicular to its normal.
inline std::string manifold_picture(const PosedShape& a, const PosedShape& b, const Manifold& got,
                                    const Vec3& axis) {
  drawing::Drawing drawing = drawing::draw_contact(a, b, got, drawing::Role::Got);
  const Real length = Real(0.7) * std::min(a.shape->radius, b.shape->radius);
  add_arrow(drawing, a.pose.position, length * axis, {drawing::Role::Expected, 3, false, true},
            "axis");
  drawing.title = "Got: " + drawing.title + ", the separating axis upward";
  return side_by_side("The manifold of two bodies",
                      {drawing::Scene{drawing, seen_from_the_side(axis)}});
}

/// The kept points, seen along the normal.
inline std::string reduction_picture(std::span<const ContactPoint> points,
                                     std::span<const ContactPoint> kept, const Vec3& normal) {
  drawing::View flat;
  flat.toward_eye = normal;
  flat.up = any_perpendicular(normal);
  drawing::Drawing drawing = drawing::draw_reduction(points, kept, normal, drawing::Role::Got);
  drawing.title = "Got: " + drawing.title;
  return side_by_side("Four points in place of many, with their separations",
                      {drawing::Scene{drawing, flat}});
}

/// The correct incident face beside the one found, with the reference normal upward.
inline std::string incident_picture(const PosedShape& body, const Vec3& normal, Index expected,
                                    Index got) {
  const auto drawn = [&](Index face, drawing::Role role) {
    drawing::MeshStyle style;
    style.role = drawing::Role::BodyB;
    style.opacity = Real(0.5);
    drawing::Drawing drawing = drawing::draw_mesh(body.mesh(), style);
    const drawing::Polygon polygon =
        drawing::face_polygon(body.mesh(), face, role, Real(0.9), Real(2e-3));
    if (polygon.corners.size() >= 3) drawing.polygons.push_back(polygon);
    drawing = transformed(drawing, body.pose);
    const Real radius = body.shape->radius;
    add_arrow(drawing, body.pose.position - 2 * radius * normal, Real(0.8) * radius * normal,
              {drawing::Role::Reference, 3, false, true}, "reference normal");
    drawing.title = "face " + std::to_string(face);
    return drawing;
  };
  drawing::View view;
  view.up = normal;
  view.toward_eye = any_perpendicular(normal) - Real(0.6) * normal;
  return expected_beside_got("The face most against the reference normal, seen from below",
                             drawn(expected, drawing::Role::Expected),
                             drawn(got, drawing::Role::Got), view);
}

}  // namespace cs550::test
