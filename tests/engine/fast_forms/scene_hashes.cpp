// Prints the state hash of every shipped scene after some steps, with both qualities.
#include <cstdio>
#include <string>

#include "cs550/scene.hpp"

namespace {

constexpr int steps = 40;

void print_hash(const cs550::Scene& scene, cs550::Quality quality, const char* name) {
  cs550::World world = cs550::make_world(scene);
  cs550::set_quality(world.settings(), quality);
  for (int step = 0; step < steps; ++step) world.step(scene.h);
  std::printf("%s, %s: %016llx\n", scene.name.c_str(), name,
              static_cast<unsigned long long>(world.state_hash()));
}

}  // namespace

int main() {
  for (const std::string& name : cs550::shipped_scenes()) {
    const cs550::SceneResult found = cs550::find_scene(name);
    if (!found) {
      std::printf("%s\n", found.error.c_str());
      return 1;
    }
    print_hash(found.scene, cs550::Quality::Accurate, "accurate");
    print_hash(found.scene, cs550::Quality::Game, "game");
  }
}
