/// This engine as a program uses it: through the world, with each of the two named settings.
#include "benchmarks/engines/engine.hpp"

namespace cs550::bench {
namespace {

class OwnSimulation : public Simulation {
 public:
  OwnSimulation(const BenchScene& scene, const WorldSettings& settings) : world_(settings) {
    for (const BodyDef& body : scene.bodies) ids_.push_back(world_.add_body(body));
  }

  void step(Real h) override { world_.step(h); }

  BodyMotion motion(std::size_t index) const override {
    const RigidBody& body = world_.body(ids_[index]);
    return {body.pose.position.cast<double>(), body.pose.orientation.cast<double>(),
            body.linear_velocity.cast<double>(), body.angular_velocity.cast<double>()};
  }

 private:
  World world_;
  std::vector<BodyId> ids_;
};

std::unique_ptr<Simulation> start(const BenchScene& scene, WorldSettings settings, int substeps) {
  settings.substeps = substeps;
  return std::make_unique<OwnSimulation>(scene, settings);
}

std::unique_ptr<Simulation> start_accurate(const BenchScene& scene, int substeps) {
  return start(scene, accurate_settings(), substeps);
}

std::unique_ptr<Simulation> start_game(const BenchScene& scene, int substeps) {
  return start(scene, game_settings(), substeps);
}

}  // namespace

std::vector<Engine> own_engines() {
  const int accurate = accurate_settings().substeps;
  const int game = game_settings().substeps;
  return {{"this engine, accurate", "substeps", accurate, {4, 8, 12, 16}, start_accurate},
          {"this engine, game", "substeps", game, {2, 3, 4, 6}, start_game}};
}

}  // namespace cs550::bench
