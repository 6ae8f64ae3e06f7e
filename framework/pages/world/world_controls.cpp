#include "pages/world/world_controls.hpp"

namespace cs550::pages {
namespace {

/// An enumeration as a choice. @pre its enumerators are 0, 1, … in the order of the names
template <class Enum>
void visit_enum(ControlVisitor& visit, const Control& control, Enum& value,
                std::span<const char* const> names) {
  int place = static_cast<int>(value);
  visit.choice(control, place, names);
  value = static_cast<Enum>(place);
}

/// A setting for which --set accepts whatever the world does.
Control setting(const char* name, const char* label, const char* unit) {
  return {name, label, unit, setting_range(name)};
}

/// A choice of the named settings. The last name stands for all others.
void visit_quality(WorldSettings& settings, ControlVisitor& visit) {
  constexpr const char* names[] = {"accurate", "game", "custom"};
  constexpr int custom = 2;
  int place = 0;
  while (place < custom && !has_quality(settings, static_cast<Quality>(place))) ++place;
  const int before = place;
  visit.choice({"quality", "quality", ""}, place, names);
  if (place != before && place < custom) set_quality(settings, static_cast<Quality>(place));
}

}  // namespace

void describe(WorldSettings& settings, ControlVisitor& visit) {
  constexpr const char* orders[] = {"back_and_forth", "step_by_step"};
  constexpr const char* solvers[] = {"naive", "constraint"};
  constexpr const char* models[] = {"baumgarte", "soft"};
  constexpr const char* rotations[] = {"explicit", "midpoint"};

  visit.section("Solver");
  visit_quality(settings, visit);
  visit_enum(visit, {"solver", "solver", ""}, settings.solver, solvers);
  visit.whole(setting("substeps", "substeps", ""), settings.substeps, 1, 16);
  visit.whole(setting("iterations", "iterations", ""), settings.iterations, 1, 50);
  visit.whole(setting("relax_iterations", "relax iterations", ""), settings.relax_iterations, 0,
              50);
  visit_enum(visit, {"pass_order", "pass order", ""}, settings.pass_order, orders);
  visit.toggle({"warm_starting", "warm starting", ""}, settings.warm_starting);

  visit.section("Contacts");
  visit.toggle({"temporal_coherence", "temporal coherence", ""}, settings.temporal_coherence);
  visit_enum(visit, {"contact_model", "model", ""}, settings.contact_model, models);
  visit.number(setting("contact_hertz", "stiffness", "1/s"), settings.contact_hertz, 1, 240);
  visit.number(setting("contact_damping_ratio", "damping ratio", ""),
               settings.contact_damping_ratio, 0, 50);
  visit.number(setting("baumgarte", "Baumgarte factor", ""), settings.baumgarte, 0, 1);
  visit.number(setting("slop", "slop", "lengths"), settings.slop, 0, Real(0.1));
  visit.number(setting("max_push_speed", "push-out speed", "lengths/s"), settings.max_push_speed, 0,
               20);
  visit.number(setting("restitution_threshold", "restitution above", "lengths/s"),
               settings.restitution_threshold, 0, 10);
  visit.whole(setting("restitution_iterations", "restitution iterations", ""),
              settings.restitution_iterations, 1, 50);
  visit.number(setting("over_relaxation", "over-relaxation", ""), settings.over_relaxation, 1,
               Real(1.9));
  visit.number(setting("rolling_resistance", "rolling resistance", "lengths"),
               settings.rolling_resistance, 0, Real(0.1));

  visit.section("World");
  visit.vector(setting("gravity", "gravity", "m/s²"), settings.gravity, 50);
  visit.number(setting("length_unit", "typical length", "m"), settings.length_unit, Real(0.01),
               100);
  visit_enum(visit, {"rotation", "rotation", ""}, settings.rotation, rotations);
  visit.toggle({"sleeping", "sleeping", ""}, settings.sleeping);
  visit.whole(setting("threads", "threads", ""), settings.threads, 1, 16);
  visit.toggle({"adaptive_threads", "adaptive threads", ""}, settings.adaptive_threads);
  visit.toggle({"check_stages", "check every stage", ""}, settings.check_stages);
}

}  // namespace cs550::pages
