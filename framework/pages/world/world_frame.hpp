#pragma once
/// @file world_frame.hpp
/// A running world as values: requests, and its state after each step. The viewer sees nothing else
/// of a world, so the world can run in another process.

#include <array>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"
#include "pages/base/content_archive.hpp"

namespace cs550::pages {

/// A spring between a point of a body and the mouse.
struct Pull {
  Index body = no_index;       ///< if none, nothing is pulled
  Vec3 anchor = Vec3::Zero();  ///< body frame (m)
  Vec3 target = Vec3::Zero();  ///< world (m)
};

/// A box to throw.
struct Throw {
  Vec3 position = Vec3::Zero();  ///< world (m)
  Vec3 velocity = Vec3::Zero();  ///< world (m/s)
  Real side = 1;                 ///< of the box (m)
};

/// A request to a world.
struct WorldRequest {
  std::string scene;                      ///< name or path of a scene to build; empty: continue
  std::optional<WorldSettings> settings;  ///< new settings
  int steps = 0;                          ///< number of steps to take
  Pull pull;                              ///< acts during these steps
  std::optional<Throw> thrown;            ///< before these steps
};

/// The description of a scene.
struct SceneInfo {
  std::string name;                     ///< name of its file
  std::string title;                    ///< one line
  std::string description;              ///< a few sentences
  std::vector<std::string> body_names;  ///< by body; may be empty strings
  WorldSettings settings;               ///< initial settings
  Real h = Real(1) / 60;                ///< step (s)
};

/// Measurements of one step, for plots.
struct StepSample {
  double time = 0;                            ///< s
  double kinetic = 0;                         ///< J
  double potential = 0;                       ///< J
  Vec3 linear = Vec3::Zero();                 ///< Σ P (kg·m/s)
  Vec3 angular = Vec3::Zero();                ///< Σ L + x × P (kg·m²/s)
  Real penetration = 0;                       ///< deepest, positive (m)
  int contacts = 0;                           ///< pairs that have a manifold
  int points = 0;                             ///< of all manifolds
  std::array<double, stage_count> seconds{};  ///< per stage
};

/// A world between two steps.
struct WorldFrame {
  std::optional<SceneInfo> scene;     ///< after it has been built
  std::vector<HalfEdgeMesh> meshes;   ///< meshes not sent before, in order
  std::vector<Index> mesh_of_body;    ///< by body: index among all meshes sent
  std::vector<RigidBody> bodies;      ///< all slots, also of removed bodies
  std::vector<char> is_alive;         ///< by body
  std::vector<Contact> contacts;      ///< pairs of the broad phase
  std::vector<Bounds> bounds;         ///< by body, world (m)
  std::vector<Bounds> tree;           ///< inner nodes of the broad phase (m)
  std::vector<StepSample> samples;    ///< of the last steps
  std::vector<std::string> problems;  ///< unwritten or failed stages
  bool is_lost = false;               ///< whether the next step would lose the finite state
  std::int64_t step = 0;              ///< number of steps since the beginning
  double time = 0;                    ///< simulated (s)
};

template <class Archive>
void serialize(Archive& archive, Pull& pull) {
  auto& [body, anchor, target] = pull;
  archive(body, anchor, target);
}

template <class Archive>
void serialize(Archive& archive, Throw& thrown) {
  auto& [position, velocity, side] = thrown;
  archive(position, velocity, side);
}

template <class Archive>
void serialize(Archive& archive, WorldRequest& request) {
  auto& [scene, settings, steps, pull, thrown] = request;
  archive(scene, settings, steps, pull, thrown);
}

template <class Archive>
void serialize(Archive& archive, SceneInfo& info) {
  auto& [name, title, description, body_names, settings, h] = info;
  archive(name, title, description, body_names, settings, h);
}

template <class Archive>
void serialize(Archive& archive, StepSample& sample) {
  auto& [time, kinetic, potential, linear, angular, penetration, contacts, points, seconds] =
      sample;
  archive(time, kinetic, potential, linear, angular, penetration, contacts, points, seconds);
}

template <class Archive>
void serialize(Archive& archive, WorldFrame& frame) {
  auto& [scene, meshes, mesh_of_body, bodies, is_alive, contacts, bounds, tree, samples, problems,
         is_lost, step, time] = frame;
  archive(scene, meshes, mesh_of_body, bodies, is_alive, contacts, bounds, tree, samples, problems,
          is_lost, step, time);
}

}  // namespace cs550::pages
