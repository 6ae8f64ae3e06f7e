// The scene reader: any text is a scene or is refused with a message.

#include <algorithm>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"
#include "memory_file.hpp"
#include "promise.hpp"

using namespace cs550;

namespace {

/// Small, so that a run takes milliseconds. What the limits refuse has tests of its own.
SceneLimits small_limits() {
  SceneLimits limits;
  limits.bodies = 64;
  limits.hull_points = 64;
  limits.total_points = 256;
  limits.pairs = 256;
  return limits;
}

/// For the same reason: a scene may ask for a thousand substeps of a thousand passes.
void take_few_passes(WorldSettings& settings) {
  settings.substeps = std::min(settings.substeps, 2);
  settings.iterations = std::min(settings.iterations, 4);
  settings.relax_iterations = std::min(settings.relax_iterations, 4);
  settings.restitution_iterations = std::min(settings.restitution_iterations, 4);
  settings.threads = 1;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file({data, size});
  const SceneResult result = load_scene(file.path(), small_limits());
  if (result) {
    World world = make_world(result.scene);
    take_few_passes(world.settings());
    fuzz::promise(world.body_count() > 0, "a scene has bodies");
    fuzz::promise(is_finite(world), "a scene begins with finite numbers");
    const World before = world;
    world.step(result.scene.h);
    fuzz::promise(is_finite(world) || !find_broken_stages(before, result.scene.h).empty(),
                  "after a step the world is finite, or the stage that lost it is reported");
  } else {
    fuzz::promise(result.scene.bodies.empty(), "a refused scene is empty");
    fuzz::promise(result.error.starts_with(file.path().string() + ": "), "a message names the file",
                  result.error);
    fuzz::promise(fuzz::is_printable(result.error), "a message can be printed", result.error);
  }
  return 0;
}
