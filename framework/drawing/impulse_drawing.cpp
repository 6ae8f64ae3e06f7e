#include "drawing/impulse_drawing.hpp"

#include <algorithm>

namespace cs550::drawing {
namespace {

constexpr int circle_corners = 72;

Vec3 flat(const Vec2& vector) { return {vector.x(), vector.y(), 0}; }

std::vector<Vec3> circle(Real radius) {
  std::vector<Vec3> points;
  for (int i = 0; i < circle_corners; ++i) {
    const Real angle = 2 * pi * static_cast<Real>(i) / circle_corners;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), Real(0));
  }
  return points;
}

}  // namespace

Real impulse_scale(std::span<const ContactConstraint> constraints, Real length) {
  Real largest = 0;
  for (const ContactConstraint& constraint : constraints) {
    if (std::isfinite(constraint.normal_impulse))
      largest = std::max(largest, std::abs(constraint.normal_impulse));
  }
  return largest > 0 ? length / largest : Real(1);
}

Drawing draw_impulses(std::span<const ContactConstraint> constraints, std::span<const Vec3> centers,
                      Real meters_per_impulse, Role role) {
  Drawing drawing;
  drawing.title = "Impulses on B";
  drawing.alt_text = "The accumulated impulses of " + std::to_string(constraints.size()) +
                     " contact constraints as arrows at their contacts.";
  const Stroke friction = {.role = Role::Incident, .width = Real(2.4), .arrow = true};
  bool has_friction = false;
  for (const ContactConstraint& constraint : constraints) {
    if (constraint.body_b < 0 || static_cast<std::size_t>(constraint.body_b) >= centers.size()) {
      drawing.notes.push_back("A constraint names body " + std::to_string(constraint.body_b) +
                              ", which does not exist.");
      continue;
    }
    const Vec3 contact = centers[constraint.body_b] + constraint.r_b;
    drawing.points.push_back({contact, Role::Text, Real(3.5)});
    const Vec3 tangent = constraint.tangent_impulse.x() * constraint.u +
                         constraint.tangent_impulse.y() * constraint.v();
    add_arrow(drawing, contact, meters_per_impulse * constraint.normal_impulse * constraint.n,
              {role, 3});
    if (tangent.norm() > 0) {
      add_arrow(drawing, contact, meters_per_impulse * tangent, friction);
      has_friction = true;
    }
  }
  drawing.legend = {{"contact", {Role::Text, 2}, LegendMark::Dot},
                    {"normal impulse", {.role = role, .width = 3, .arrow = true}}};
  if (has_friction) drawing.legend.push_back({"friction", friction, LegendMark::Line});
  return drawing;
}

Drawing draw_friction_disk(Real limit, std::span<const DiskImpulse> impulses, const Vec2& slip) {
  Drawing drawing;
  drawing.title = "Friction disk";
  drawing.alt_text = "The disk of radius μ·λ_n that bounds the friction impulse, with " +
                     std::to_string(impulses.size()) + " impulses and the slip.";
  Real reach = limit;
  for (const DiskImpulse& impulse : impulses) {
    if (impulse.impulse.allFinite()) reach = std::max(reach, impulse.impulse.norm());
  }
  if (!(reach > 0)) reach = 1;

  const std::vector<Vec3> disk = circle(std::max(limit, Real(0)));
  drawing.polygons.push_back({disk, Role::Reference, Real(0.35)});
  add_closed_curve(drawing, disk, {Role::Reference, 2});
  const std::vector<Vec3> square = {
      {-limit, -limit, 0}, {limit, -limit, 0}, {limit, limit, 0}, {-limit, limit, 0}};
  add_closed_curve(drawing, square, {.role = Role::Faint, .width = Real(1.4), .dashed = true});

  const Stroke axis = {.role = Role::Axis, .width = Real(1.2), .arrow = true};
  add_arrow(drawing, {-Real(1.2) * reach, 0, 0}, {Real(2.4) * reach, 0, 0}, axis, "λᵤ");
  add_arrow(drawing, {0, -Real(1.2) * reach, 0}, {0, Real(2.4) * reach, 0}, axis, "λᵥ");
  drawing.legend = {{"‖λ‖ ≤ μ·λₙ", {Role::Reference, 2}, LegendMark::Patch},
                    {"each axis by itself",
                     {.role = Role::Faint, .width = Real(1.4), .dashed = true},
                     LegendMark::Line}};
  for (const DiskImpulse& impulse : impulses) {
    // The expected arrow is wider, so that it is visible below the other.
    const Real width = impulse.role == Role::Expected ? Real(6) : Real(2.4);
    const Stroke stroke = {.role = impulse.role, .width = width, .arrow = true};
    add_arrow(drawing, Vec3::Zero(), flat(impulse.impulse), stroke, impulse.name);
    drawing.legend.push_back({impulse.name, stroke, LegendMark::Line});
  }
  if (slip.allFinite() && slip.norm() > 0) {
    // Of B relative to A.
    const Stroke stroke = {.role = Role::BodyB, .width = 2, .arrow = true};
    const Vec2 direction = slip.normalized();
    add_arrow(drawing, Vec3::Zero(), Real(0.8) * reach * flat(direction), stroke, "slip");
    drawing.legend.push_back({"direction of slip", stroke, LegendMark::Line});
  }
  return drawing;
}

Plot plot_impulses(std::span<const std::vector<Real>> history) {
  Plot plot;
  plot.title = "Normal impulse after each pass";
  plot.alt_text = "The accumulated normal impulse of each contact constraint after each pass.";
  plot.x_label = "pass";
  plot.y_label = "λₙ (N·s)";
  const std::size_t constraints = history.empty() ? 0 : history.front().size();
  for (std::size_t constraint = 0; constraint < constraints; ++constraint) {
    std::vector<Vec2> values;
    for (std::size_t pass = 0; pass < history.size(); ++pass) {
      if (constraint < history[pass].size()) {
        values.emplace_back(static_cast<Real>(pass), history[pass][constraint]);
      }
    }
    add_series(plot, "constraint " + std::to_string(constraint), std::move(values));
  }
  return plot;
}

Plot plot_convergence(std::span<const Convergence> runs, const std::string& y_label) {
  Plot plot;
  plot.title = "Convergence";
  plot.alt_text = "Errors after each pass, in powers of ten.";
  plot.x_label = "pass";
  plot.y_label = y_label;
  plot.logarithmic = true;
  for (const Convergence& run : runs) {
    std::vector<Vec2> values;
    for (std::size_t pass = 0; pass < run.errors.size(); ++pass) {
      values.emplace_back(static_cast<Real>(pass), run.errors[pass]);
    }
    add_series(plot, run.name, std::move(values)).dashed = run.dashed;
  }
  return plot;
}

}  // namespace cs550::drawing
