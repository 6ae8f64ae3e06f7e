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

Engine own_engine(const char* name, WorldSettings settings, std::vector<int> efforts) {
  const auto start = [settings](const BenchScene& scene, int substeps) {
    WorldSettings with_effort = settings;
    with_effort.substeps = substeps;
    return std::make_unique<OwnSimulation>(scene, with_effort);
  };
  return {name, "substeps", settings.substeps, std::move(efforts), start};
}

}  // namespace

std::vector<Engine> own_engines(int threads) {
  WorldSettings accurate = accurate_settings();
  WorldSettings game = game_settings();
  accurate.threads = game.threads = threads;
  accurate.adaptive_threads = game.adaptive_threads = false;
  return {own_engine("this engine, accurate", accurate, {4, 6, 9, 12}),
          own_engine("this engine, game", game, {2, 3, 4, 6})};
}

}  // namespace cs550::bench
