/// This engine as a program uses it: through the world. Once with its default settings, which query
/// every pair in every step, and once with temporal coherence.
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

WorldSettings coherent() {
  WorldSettings settings;
  settings.temporal_coherence = true;
  return settings;
}

std::unique_ptr<Simulation> start(const BenchScene& scene, WorldSettings settings, int substeps) {
  settings.substeps = substeps;
  return std::make_unique<OwnSimulation>(scene, settings);
}

}  // namespace

std::vector<Engine> own_engines() {
  const std::vector<int> efforts = {4, 8, 12, 16};
  return {
      {"this engine", "substeps", WorldSettings().substeps, efforts,
       [](const BenchScene& scene, int substeps) { return start(scene, {}, substeps); }},
      {"this engine, coherent", "substeps", coherent().substeps, efforts,
       [](const BenchScene& scene, int substeps) { return start(scene, coherent(), substeps); }}};
}

}  // namespace cs550::bench
