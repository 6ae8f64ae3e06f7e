// Lab 1: a freely rotating body, integrated by the explicit method and by the implicit midpoint.
#include "cs550/integration.hpp"
#include "drawing/trajectory_drawing.hpp"
#include "pages/base/units.hpp"
#include "pages/labs/lab_page.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {
namespace {

using drawing::Drawing;
using drawing::Recorded;
using drawing::Role;

struct IntegrationSettings {
  Vec3 half_extents = {Real(0.2), Real(0.5), Real(1)};  // m
  Vec3 spin = {Real(0.2), 4, Real(0.2)};                // rad/s, body frame at the start
  Real h = Real(1) / 60;                                // s
  Real seconds = 5;
  int step = last_step;

  bool operator==(const IntegrationSettings&) const = default;
};

void describe(IntegrationSettings& settings, ControlVisitor& visit) {
  visit.section("Free body");
  visit.vector({"half_extents", "half extents", "m"}, settings.half_extents, 2);
  visit.vector({"spin", "spin", "rad/s"}, settings.spin, 20);
  visit.section("Integration");
  visit.number({"h", "time step", "s"}, settings.h, Real(0.001), Real(0.1));
  visit.number({"seconds", "duration", "s"}, settings.seconds, Real(0.5), 20);
  visit.step({"step", "shown step", ""}, settings.step, 2000);
}

/// The motion of the body by one method.
struct Run {
  std::vector<Pose> poses;
  std::vector<Vec3> spins;  // body frame
  std::vector<Real> energies;
  std::vector<Real> momenta;  // |L| by R·I·Rᵀ·ω
};

/// The mass is 1 kg, because only ratios of inertias matter here.
RigidBody spinning_box(const IntegrationSettings& settings) {
  const Vec3 squared = settings.half_extents.cwiseAbs().cwiseMax(Real(0.01)).cwiseAbs2();
  const Vec3 inertia(squared.y() + squared.z(), squared.x() + squared.z(),
                     squared.x() + squared.y());
  RigidBody body = make_dynamic_body(1, (inertia / 3).asDiagonal(), {});
  set_velocity(body, Vec3::Zero(), settings.spin);
  return body;
}

/// The last step is at the end of the duration, which rounding may put just before it.
int step_count_of(const IntegrationSettings& settings) {
  return static_cast<int>(std::floor(settings.seconds / settings.h + Real(1e-3)));
}

Run run(const IntegrationSettings& settings, RotationMethod method) {
  RigidBody body = spinning_box(settings);
  Run run;
  const int steps = step_count_of(settings);
  for (int i = 0; i <= steps; ++i) {
    refresh_velocity(body);
    const Vec3 spin = body.pose.unrotate(body.angular_velocity);
    run.poses.push_back(body.pose);
    run.spins.push_back(spin);
    run.energies.push_back(Real(0.5) * spin.dot(body.inertia * spin));
    run.momenta.push_back((body.inertia * spin).norm());
    integrate_pose(body, settings.h, method);
  }
  return run;
}

/// The poses of a run up to the displayed one.
template <class T>
std::span<const T> until(const std::vector<T>& values, int step) {
  return {values.data(), static_cast<std::size_t>(step) + 1};
}

/// The column of a method: the box with the trail of a corner, and the polhode below it.
Drawing column(const IntegrationSettings& settings, const Run& run, int step, Role role,
               const std::string& name, Real x) {
  const RigidBody start = spinning_box(settings);
  const Vec3 extents = settings.half_extents.cwiseAbs();
  const Vec3 momentum = start.pose.rotate(start.inertia * settings.spin);
  const Vec3 tip(0, 0, extents.z());
  Drawing body = drawing::draw_box(run.poses[step], extents, role, Real(0.55));
  drawing::append(body, drawing::draw_trail(until(run.poses, step), tip, {role, 2, false, false},
                                            name + ": path of a face centre"));
  drawing::add_arrow(body, Vec3::Zero(), Real(1.5) * momentum.normalized(),
                     {Role::Highlight, Real(2.5), false, true}, "L");
  body.labels.push_back({Vec3(0, 0, Real(1.55)), name, Role::Text});
  Drawing result = drawing::transformed(body, {{x, 0, Real(1.25)}, Quat::Identity()});
  if (run.energies.front() == 0) return result;  // the ellipsoid is a point

  Drawing polhode = drawing::draw_energy_ellipsoid(start.inertia.diagonal(), run.energies.front());
  Drawing curve = drawing::draw_polhode(start.inertia.diagonal(), until(run.spins, step),
                                        {role, Real(2.5), false, false}, name + ": ω of the body");
  drawing::append(polhode, curve);
  polhode.labels.clear();
  const Real largest = std::sqrt(2 * run.energies.front() / start.inertia.diagonal().minCoeff());
  drawing::append(result, drawing::transformed(scaled(polhode, Real(1.05) / largest),
                                               {{x, 0, Real(-1.2)}, Quat::Identity()}));
  return result;
}

std::string change(const std::vector<Real>& values, int step) {
  const double start = static_cast<double>(values.front());
  const double now = static_cast<double>(values[step]);
  if (start == 0) return now == 0 ? quantity(0, "%") : "from zero to " + quantity(now, "");
  return quantity(100 * (now / start - 1), "%");
}

Content show(const IntegrationSettings& settings) {
  const Run explicit_run = run(settings, RotationMethod::Explicit);
  const Run midpoint_run = run(settings, RotationMethod::ImplicitMidpoint);
  Content content;
  content.step_count = static_cast<int>(explicit_run.poses.size());
  const int step = shown_step(settings.step, content.step_count);
  const Real apart = Real(1.55);
  content.drawing = column(settings, explicit_run, step, Role::Got, "explicit", -apart);
  drawing::append(content.drawing,
                  column(settings, midpoint_run, step, Role::BodyA, "midpoint", apart));
  content.drawing.legend = {
      {"energy ellipsoid ω·Iω = 2T", {Role::Faint, 1, false, false}, drawing::LegendMark::Patch},
      {"explicit", {Role::Got, 3, false, false}, {}},
      {"implicit midpoint", {Role::BodyA, 3, false, false}, {}},
      {"angular momentum L", {Role::Highlight, 2, false, true}, {}},
      {"axes of ω in the body", {Role::Axis, 2, false, true}, {}}};
  content.drawing.notes.clear();
  if (explicit_run.energies.front() == 0) {
    content.drawing.notes.push_back("Without spin there is no energy and no ellipsoid.");
  }

  const std::vector<Recorded> energies{{"explicit", explicit_run.energies, Role::Got, false},
                                       {"midpoint", midpoint_run.energies, Role::BodyA, false}};
  const std::vector<Recorded> momenta{{"explicit", explicit_run.momenta, Role::Got, false},
                                      {"midpoint", midpoint_run.momenta, Role::BodyA, false}};
  content.plots.push_back(drawing::plot_over_time("Energy", "J", settings.h, energies));
  content.plots.push_back(drawing::plot_over_time("|L|", "kg·m²/s", settings.h, momenta));
  content.facts = {
      {"time", quantity(static_cast<double>(static_cast<Real>(step) * settings.h), "s")},
      {"energy, explicit", change(explicit_run.energies, step)},
      {"energy, midpoint", change(midpoint_run.energies, step)},
      {"|L|, explicit", change(explicit_run.momenta, step)},
      {"|L|, midpoint", change(midpoint_run.momenta, step)}};
  content.focus = {{0, 0, Real(0.3)}, Real(2.9)};
  return content;
}

}  // namespace

std::unique_ptr<Page> make_integration_page(Isolation isolation) {
  LabPageParts<IntegrationSettings> parts;
  parts.lab = 1;
  parts.story =
      "A box spins freely about its middle axis and flips over. Energy is conserved only while ω "
      "stays on the ellipsoid below: the explicit method leaves it.";
  parts.first_view = seen_from(Real(-1.4), Real(0.2));
  parts.describe = describe;
  parts.show = show;
  return std::make_unique<LabPage<IntegrationSettings>>(parts, isolation);
}

}  // namespace cs550::pages
