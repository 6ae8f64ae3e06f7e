#pragma once
/// @file simulation.hpp
/// The simulation of the world page.

#include <map>
#include <optional>
#include <vector>

#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// Owns a world and answers requests.
class Simulation {
 public:
  /// @throws std::runtime_error for a scene that cannot be read
  WorldFrame serve(const WorldRequest& request);

 private:
  void build(const std::string& scene, WorldFrame& frame);
  void step();
  void throw_box(const Throw& thrown);
  void pull(const Pull& pull);
  void describe(WorldFrame& frame);
  StepSample sample() const;
  Index mesh_number(const ShapePtr& shape, WorldFrame& frame);

  std::optional<World> world_;
  Real h_ = Real(1) / 60;
  std::size_t stepped_ = 0;  ///< number of bodies whose velocities a step has derived
  std::map<ShapePtr, Index> sent_meshes_;
  std::vector<StageProblem> lost_;  ///< what the next step would break, if the world stands still
};

}  // namespace cs550::pages
