#include "engine/scenes/scene_settings.hpp"

#include "engine/world/settings_ranges.hpp"

namespace cs550 {

WorldSettings read_settings(SceneReader world) {
  WorldSettings settings;
  Quality quality = Quality::Accurate;
  world.read("quality", quality,
             Names<Quality>{{"accurate", Quality::Accurate}, {"game", Quality::Game}});
  set_quality(settings, quality);
  for_each_range(settings, [&world](const char* name, auto& value, auto... range) {
    world.read(name, value, range...);
  });

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
  world.read("adaptive_threads", settings.adaptive_threads);

  world.read("check_stages", settings.check_stages);
  world.read("audit_momentum", settings.audit_momentum);
  world.refuse_other_keys();
  return settings;
}

}  // namespace cs550
