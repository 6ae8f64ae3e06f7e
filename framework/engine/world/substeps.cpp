#include "engine/world/stages.hpp"

namespace cs550 {

void run_substeps(WorldState& world, const ContactStep& step, int count) {
  run_stage(world, Stage::Prepare, prepare, step);
  for (int i = 0; i < count; ++i) substep(world, step);
}

}  // namespace cs550
