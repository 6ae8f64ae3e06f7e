#include "engine/contacts/contact_constraints.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

void run_substeps(WorldState& world, const ContactStep& step, int count) {
  run_stage(world, Stage::Prepare, prepare, step);
  if (substeps_go_by_part(world)) {
    run_stage(world, Stage::Solve, run_substeps_by_part, step, count);
  } else {
    for (int i = 0; i < count; ++i) substep(world, step);
  }
  run_stage(world, Stage::Solve, [](WorldState& state) { read_back_impulses(state); });
}

}  // namespace cs550
