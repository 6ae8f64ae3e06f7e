#include "drawing/trajectory_drawing.hpp"

#include <algorithm>
#include <array>

namespace cs550::drawing {
namespace {

constexpr int parallels = 12;
constexpr int meridians = 24;

Vec3 on_ellipsoid(const Vec3& semi_axes, int parallel, int meridian) {
  const Real latitude = pi * static_cast<Real>(parallel) / parallels;
  const Real longitude = 2 * pi * static_cast<Real>(meridian) / meridians;
  return semi_axes.cwiseProduct(Vec3(std::sin(latitude) * std::cos(longitude),
                                     std::sin(latitude) * std::sin(longitude), std::cos(latitude)));
}

}  // namespace

Drawing draw_trail(std::span<const Pose> poses, const Vec3& body_point, const Stroke& stroke,
                   const std::string& name) {
  Drawing drawing;
  drawing.title = name;
  drawing.alt_text = "The path of a point of the body over " + std::to_string(poses.size()) +
                     " poses: " + name + '.';
  std::vector<Vec3> trail;
  for (const Pose& pose : poses) trail.push_back(pose.to_world(body_point));
  add_curve(drawing, trail, stroke);
  if (!trail.empty()) {
    drawing.points.push_back({trail.front(), Role::Axis, 3});
    drawing.points.push_back({trail.back(), stroke.role, 5});
  }
  drawing.legend = {{name, stroke, LegendMark::Line}};
  return drawing;
}

Drawing draw_box(const Pose& pose, const Vec3& half_extents, Role role, Real opacity) {
  Drawing drawing;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {Real(-1), Real(1)}) {
      Polygon face{{}, role, opacity};
      for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        Vec3 corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = side * static_cast<Real>(s);
        corner[(axis + 2) % 3] = static_cast<Real>(t);
        face.corners.push_back(pose.to_world(corner.cwiseProduct(half_extents)));
      }
      add_closed_curve(drawing, face.corners, {role, Real(1.4)});
      drawing.polygons.push_back(face);
    }
  }
  return drawing;
}

Drawing draw_energy_ellipsoid(const Vec3& inertia, Real energy) {
  Drawing drawing;
  drawing.title = "Energy ellipsoid";
  const Vec3 semi_axes = (2 * energy * inertia.cwiseInverse()).cwiseMax(0).cwiseSqrt();
  for (int i = 0; i < parallels; ++i) {
    for (int k = 0; k < meridians; ++k) {
      Polygon patch{{on_ellipsoid(semi_axes, i, k), on_ellipsoid(semi_axes, i + 1, k),
                     on_ellipsoid(semi_axes, i + 1, k + 1), on_ellipsoid(semi_axes, i, k + 1)},
                    Role::Faint,
                    Real(0.75)};
      // Patches at the poles are triangles.
      if (i == 0) patch.corners.pop_back();
      if (i == parallels - 1) patch.corners.erase(patch.corners.begin() + 1);
      drawing.polygons.push_back(std::move(patch));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    add_arrow(drawing, semi_axes[axis] * Vec3::Unit(axis),
              Real(0.25) * semi_axes.maxCoeff() * Vec3::Unit(axis), {Role::Axis, 2},
              std::array{"ω₁", "ω₂", "ω₃"}.at(axis));
  }
  return drawing;
}

Drawing draw_polhode(const Vec3& inertia, std::span<const Vec3> angular_velocities,
                     const Stroke& stroke, const std::string& name) {
  Drawing drawing;
  if (!angular_velocities.empty()) {
    const Vec3& start = angular_velocities.front();
    const Real energy = Real(0.5) * start.dot(inertia.cwiseProduct(start));
    if (std::isfinite(energy)) drawing = draw_energy_ellipsoid(inertia, energy);
    drawing.points.push_back({start, Role::Axis, 4});
  }
  drawing.title = "Polhode: " + name;
  drawing.alt_text =
      "The angular velocity in the body frame on the ellipsoid of its first energy: " + name + '.';
  add_curve(drawing, angular_velocities, stroke);
  drawing.legend = {{name, stroke, LegendMark::Line},
                    {"energy at the start", {Role::Faint, 2}, LegendMark::Patch}};
  return drawing;
}

Plot plot_over_time(const std::string& title, const std::string& y_label, Real h,
                    std::span<const Recorded> recorded) {
  Plot plot;
  plot.title = title;
  plot.alt_text = title + " over time.";
  plot.x_label = "time (s)";
  plot.y_label = y_label;
  for (const Recorded& run : recorded) {
    std::vector<Vec2> values;
    for (std::size_t i = 0; i < run.values.size(); ++i) {
      values.emplace_back(static_cast<Real>(i) * h, run.values[i]);
    }
    Series& series = add_series(plot, run.name, std::move(values));
    series.role = run.role;
    series.dashed = run.dashed;
  }
  return plot;
}

}  // namespace cs550::drawing
