#include "engine/scenes/scene_settings.hpp"

#include "engine/threads/thread_team.hpp"

namespace cs550 {

WorldSettings read_settings(SceneReader world) {
  constexpr int most_passes = 1000;
  WorldSettings settings;
  Quality quality = Quality::Accurate;
  world.read("quality", quality,
             Names<Quality>{{"accurate", Quality::Accurate}, {"game", Quality::Game}});
  set_quality(settings, quality);
  world.read("gravity", settings.gravity);
  world.read("length_unit", settings.length_unit, Range::Positive);

  world.read("substeps", settings.substeps, 1, most_passes);
  world.read("iterations", settings.iterations, 0, most_passes);
  world.read("relax_iterations", settings.relax_iterations, 0, most_passes);
  world.read("pass_order", settings.pass_order,
             Names<PassOrder>{{"back_and_forth", PassOrder::BackAndForth},
                              {"step_by_step", PassOrder::StepByStep}});
  world.read(
      "solver", settings.solver,
      Names<SolverKind>{{"constraint", SolverKind::Constraint}, {"naive", SolverKind::Naive}});
  world.read(
      "contact_model", settings.contact_model,
      Names<ContactModel>{{"soft", ContactModel::Soft}, {"baumgarte", ContactModel::Baumgarte}});
  world.read("rotation", settings.rotation,
             Names<RotationMethod>{{"implicit_midpoint", RotationMethod::ImplicitMidpoint},
                                   {"explicit", RotationMethod::Explicit}});
  world.read("warm_starting", settings.warm_starting);
  world.read("temporal_coherence", settings.temporal_coherence);
  world.read("sleeping", settings.sleeping);
  world.read("threads", settings.threads, 1, most_threads);
  world.read("adaptive_threads", settings.adaptive_threads);

  world.read("contact_hertz", settings.contact_hertz, Range::Positive);
  world.read("contact_damping_ratio", settings.contact_damping_ratio, Range::NotNegative);
  world.read("baumgarte", settings.baumgarte, Range::ZeroToOne);
  world.read("slop", settings.slop, Range::NotNegative);
  world.read("max_push_speed", settings.max_push_speed, Range::NotNegative);
  world.read("restitution_threshold", settings.restitution_threshold, Range::NotNegative);
  world.read("restitution_iterations", settings.restitution_iterations, 0, most_passes);
  world.read("over_relaxation", settings.over_relaxation, 1, 1.9);
  world.read("rolling_resistance", settings.rolling_resistance, Range::NotNegative);

  world.read("check_stages", settings.check_stages);
  world.read("audit_momentum", settings.audit_momentum);
  world.refuse_other_keys();
  return settings;
}

}  // namespace cs550
