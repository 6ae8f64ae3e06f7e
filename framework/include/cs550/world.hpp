#pragma once
/// @file world.hpp
/// Bodies, and the step that puts the seven labs together.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cs550/constraint_solver.hpp"
#include "cs550/contact.hpp"
#include "cs550/convex_shape.hpp"
#include "cs550/integration.hpp"

namespace cs550 {

/// Which lab's solver runs.
enum class SolverKind : std::uint8_t { Naive, Constraint };

/// What can be switched while a world runs. Lengths and speeds follow the length unit.
struct WorldSettings {
  Vec3 gravity = {0, 0, Real(-9.81)};  ///< m/s²; the z axis points up
  Real length_unit = 1;                ///< the size of a typical body (m)

  int substeps = 4;
  int iterations = 1;        ///< passes with bias in a substep
  int relax_iterations = 1;  ///< passes without bias in a substep, soft contacts only
  SolverKind solver = SolverKind::Constraint;
  ContactModel contact_model = ContactModel::Soft;
  RotationMethod rotation = RotationMethod::ImplicitMidpoint;
  bool warm_starting = true;

  Real contact_hertz = 30;
  Real contact_damping_ratio = 10;
  Real baumgarte = Real(0.2);
  Real slop = Real(1e-3);                  ///< of the length unit
  Real max_push_speed = 3;                 ///< length units per second
  Real restitution_threshold = Real(0.5);  ///< length units per second
  int restitution_iterations = 8;

  bool check_stages = false;    ///< check after each stage what it promised (rule 5)
  bool audit_momentum = false;  ///< keep the ledger of momentum_error()
};

/// Which bodies may touch: A and B do if each one's mask has a bit of the other's category.
struct CollisionFilter {
  std::uint32_t category = 1;
  std::uint32_t mask = 0xffffffffU;
};

/// Everything that a new body needs.
struct BodyDef {
  BodyKind kind = BodyKind::Dynamic;
  ShapePtr shape;            ///< required
  Real density = 1000;       ///< kg/m³
  std::optional<Real> mass;  ///< kg; overrides the density
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero();   ///< world (m/s)
  Vec3 angular_velocity = Vec3::Zero();  ///< world (rad/s)
  Real friction = Real(0.6);             ///< μ; a pair uses the geometric mean
  Real restitution = 0;                  ///< e; a pair uses the larger one
  CollisionFilter filter;
};

/// Names a body for as long as it lives; never names a later one that takes its place.
struct BodyId {
  Index index = no_index;  ///< place in World::bodies()
  std::uint32_t generation = 0;

  bool operator==(const BodyId& other) const {
    return index == other.index && generation == other.generation;
  }
};

/// The stages of a step, in order.
enum class Stage : std::uint8_t {
  Integrate,   ///< lab 1
  BroadPhase,  ///< given
  Collide,     ///< labs 3 and 4
  Manifolds,   ///< lab 5
  Prepare,     ///< rows and masses, lab 7
  Solve,       ///< labs 6 and 7
};
inline constexpr int stage_count = 6;
const char* to_string(Stage stage);

/// A stage that is not written yet, or that broke a promise.
struct StageProblem {
  Stage stage = Stage::Integrate;
  int lab = 0;
  Index body = no_index;  ///< or no_index
  std::int64_t step = 0;
  std::string message;  ///< "not implemented: L4.4 …", or the promise that was broken
};

/// What one step did.
struct StepStats {
  std::array<double, stage_count> seconds{};  ///< per stage
  int pairs = 0;                              ///< from the broad phase
  int contacts = 0;                           ///< pairs with a manifold
  int points = 0;
  Real deepest_separation = 0;  ///< most negative separation, 0 if none (m)
};

/// Two bodies that began or ceased to touch.
struct ContactEvent {
  BodyId a;
  BodyId b;
};

/// What a ray met first.
struct RayHit {
  BodyId body;
  Index face = no_index;
  Real distance = 0;           ///< along the ray (m)
  Vec3 point = Vec3::Zero();   ///< world (m)
  Vec3 normal = Vec3::Zero();  ///< of the face, world
};

class AabbTree;
struct WorldState;

/// Bodies that move, collide and rest. A plain value: a copy of a world continues identically, which
/// is how a state is saved and restored.
///
/// A stage whose lab is not written yet is skipped and named in problems(); the others still run.
class World {
 public:
  explicit World(const WorldSettings& settings = {});
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  WorldSettings& settings();
  const WorldSettings& settings() const;

  /// Adds a body at any time between steps.
  /// @throws std::invalid_argument if the shape is missing or a number is not finite or has no
  ///         physical meaning; the message names it
  BodyId add_body(const BodyDef& def);
  /// Removes a body with its contacts at any time between steps; an id that is out of date is ignored.
  void remove_body(BodyId id);
  bool is_alive(BodyId id) const;
  int body_count() const;

  /// All places of bodies, those of removed ones included: is_alive() of id_at(i) tells.
  std::span<const RigidBody> bodies() const;
  BodyId id_at(Index index) const;
  const RigidBody& body(BodyId id) const;
  /// For forces and impulses (add_force(), apply_impulse()) and for moving kinematic bodies.
  RigidBody& body(BodyId id);
  const ShapePtr& shape(BodyId id) const;
  const BodyDef& definition(BodyId id) const;
  PosedShape posed_shape(BodyId id) const;

  /// Advances the world. @param h s, positive; 1/60 is usual
  void step(Real h);
  std::int64_t step_count() const;
  double time() const;  ///< simulated (s)

  /// Pairs that the broad phase found, sorted by bodies; those with an empty manifold do not touch.
  std::span<const Contact> contacts() const;
  /// The axis of each of contacts(), in the same order.
  std::span<const SeparatingAxis> axes() const;
  std::span<const ContactEvent> began() const;  ///< touching since the last step
  std::span<const ContactEvent> ended() const;  ///< no longer touching since the last step
  const StepStats& stats() const;
  /// What was missing or broken in the last step; empty in a finished engine.
  std::span<const StageProblem> problems() const;

  /// The nearest face that a ray meets from outside.
  /// @param direction world frame, need not be unit; @param length m
  std::optional<RayHit> ray_cast(const Vec3& origin, const Vec3& direction, Real length) const;
  /// Bodies whose bounds overlap a box, sorted by index.
  std::vector<BodyId> query(const Bounds& bounds) const;
  /// The nodes of the broad phase's tree, for drawing.
  const AabbTree& broad_phase() const;

  /// A hash of all poses and momenta, bit for bit (FNV-1a): equal hashes, equal states.
  std::uint64_t state_hash() const;

  /// |ΔP − J|/Σ|P| over the run, J being the impulse of gravity, of applied forces and of immovable
  /// bodies; needs settings().audit_momentum from the start. Rounding is all that should remain.
  double momentum_error() const;

 private:
  std::unique_ptr<WorldState> state_;
};

}  // namespace cs550
