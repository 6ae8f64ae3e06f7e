// The scene reader: any text is a scene or is refused with a message.

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file({data, size});
  const SceneResult result = load_scene(file.path(), small_limits());
  if (result) {
    const World world = make_world(result.scene);
    fuzz::promise(world.body_count() > 0, "a scene has bodies");
  } else {
    fuzz::promise(result.scene.bodies.empty(), "a refused scene is empty");
    fuzz::promise(result.error.starts_with(file.path().string() + ": "), "a message names the file",
                  result.error);
    fuzz::promise(fuzz::is_printable(result.error), "a message can be printed", result.error);
  }
  return 0;
}
