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
enum class SolverKind : std::uint8_t {
  Naive,       ///< lab 6
  Constraint,  ///< lab 7
};

/// What can be switched while a world runs. Lengths and speeds follow the length unit.
struct WorldSettings {
  Vec3 gravity = {0, 0, Real(-9.81)};  ///< m/s²; the z axis points up
  Real length_unit = 1;                ///< the size of a typical body (m)

  int substeps = 8;          ///< of one step
  int iterations = 1;        ///< passes with bias in a substep
  int relax_iterations = 2;  ///< passes without bias in a substep, soft contacts only
  SolverKind solver = SolverKind::Constraint;                  ///< whose solver runs
  ContactModel contact_model = ContactModel::Soft;             ///< how penetration is undone
  RotationMethod rotation = RotationMethod::ImplicitMidpoint;  ///< how bodies turn
  bool warm_starting = true;  ///< begin with the impulses of the last step

  Real contact_hertz = 80;                 ///< stiffness of soft contacts (1/s)
  Real contact_damping_ratio = 4;          ///< ζ of soft contacts; 1 is critical
  Real baumgarte = Real(0.2);              ///< β: share of the error undone per step
  Real slop = Real(1e-3);                  ///< of the length unit
  Real max_push_speed = 3;                 ///< length units per second
  Real restitution_threshold = Real(0.5);  ///< length units per second
  int restitution_iterations = 8;          ///< sweeps of apply_restitution()

  bool check_stages = false;    ///< check after each stage what it promised (rule 5)
  bool audit_momentum = false;  ///< keep the audit of momentum_error()
};

/// Which bodies may touch: A and B do if each one's mask has a bit of the other's category.
struct CollisionFilter {
  std::uint32_t category = 1;        ///< bits: what the body is
  std::uint32_t mask = 0xffffffffU;  ///< bits: what it meets
};

/// Everything that a new body needs.
struct BodyDef {
  BodyKind kind = BodyKind::Dynamic;  ///< what makes it move
  ShapePtr shape;                     ///< required
  Real density = 1000;                ///< kg/m³
  std::optional<Real> mass;           ///< kg; overrides the density
  Pose pose;                          ///< at the start
  Vec3 linear_velocity = {0, 0, 0};   ///< world (m/s)
  Vec3 angular_velocity = {0, 0, 0};  ///< world (rad/s)
  Real friction = Real(0.6);          ///< μ; a pair uses the geometric mean
  Real restitution = 0;               ///< e; a pair uses the larger one
  CollisionFilter filter;             ///< which bodies it may touch
};

/// Names a body for as long as it lives; never names a later one that takes its place.
struct BodyId {
  Index index = no_index;        ///< place in World::bodies()
  std::uint32_t generation = 0;  ///< how many bodies had this place before

  /// Whether both name the same body.
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
  Prepare,     ///< constraints and masses, lab 7
  Solve,       ///< labs 6 and 7
};
/// How many stages a step has.
inline constexpr int stage_count = 6;
/// The name of a stage for people.
const char* to_string(Stage stage);

/// A stage that is not written yet, or that broke a promise.
struct StageProblem {
  Stage stage = Stage::Integrate;  ///< where it was noticed
  int lab = 0;                     ///< whose code it is
  Index body = no_index;           ///< or no_index
  std::int64_t step = 0;           ///< number of the step
  std::string message;             ///< "not implemented: L4.4 …", or the promise that was broken
};

/// What one step did.
struct StepStats {
  std::array<double, stage_count> seconds{};  ///< per stage
  int pairs = 0;                              ///< from the broad phase
  int contacts = 0;                           ///< pairs with a manifold
  int points = 0;                             ///< of all manifolds
  Real deepest_separation = 0;                ///< most negative separation, 0 if none (m)
};

/// Two bodies that began or ceased to touch.
struct ContactEvent {
  BodyId a;  ///< the one with the smaller index
  BodyId b;  ///< the other one
};

/// What a ray met first.
struct RayHit {
  BodyId body;              ///< the one that was hit
  Index face = no_index;    ///< of its mesh
  Real distance = 0;        ///< along the ray (m)
  Vec3 point = {0, 0, 0};   ///< world (m)
  Vec3 normal = {0, 0, 0};  ///< of the face, world
};

class AabbTree;
struct WorldState;

/// Bodies that move, collide and rest. A plain value: a copy of a world continues identically, which
/// is how a state is saved and restored.
///
/// A stage whose lab is not written yet is skipped and named in problems(); the others still run.
class World {
 public:
  /// Without bodies, at time 0.
  explicit World(const WorldSettings& settings = {});
  /// Copies and moves take all that decides how it goes on.
  /// @{
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  /// @}
  ~World();

  /// May be changed between steps.
  /// @{
  WorldSettings& settings();
  const WorldSettings& settings() const;
  /// @}

  /// Adds a body at any time between steps.
  /// @throws std::invalid_argument if the shape is missing or a number is not finite or has no
  ///         physical meaning; the message names it
  BodyId add_body(const BodyDef& def);
  /// Removes a body with its contacts at any time between steps; an id that is out of date is ignored.
  void remove_body(BodyId id);
  /// Whether the body is still there.
  bool is_alive(BodyId id) const;
  /// How many bodies there are, removed ones not counted.
  int body_count() const;

  /// All places of bodies, those of removed ones included: is_alive() of id_at(i) tells.
  std::span<const RigidBody> bodies() const;
  /// The id of the body at a place of bodies().
  BodyId id_at(Index index) const;
  /// A body by its id, which must be alive.
  const RigidBody& body(BodyId id) const;
  /// For forces and impulses (add_force(), apply_impulse()) and for moving kinematic bodies.
  RigidBody& body(BodyId id);
  /// What a body was made from, and its shape where it is now.
  /// @{
  const ShapePtr& shape(BodyId id) const;
  const BodyDef& definition(BodyId id) const;
  PosedShape posed_shape(BodyId id) const;
  /// @}

  /// Advances the world. @param h s, positive; 1/60 is usual
  void step(Real h);
  std::int64_t step_count() const;  ///< since the world was made
  double time() const;              ///< simulated (s)

  /// Pairs that the broad phase found, sorted by bodies; those with an empty manifold do not touch.
  std::span<const Contact> contacts() const;
  /// The axis of each of contacts(), in the same order.
  std::span<const SeparatingAxis> axes() const;
  std::span<const ContactEvent> began() const;  ///< touching since the last step
  std::span<const ContactEvent> ended() const;  ///< no longer touching since the last step
  const StepStats& stats() const;               ///< of the last step
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

  /// |ΔP − J| over the run, relative to Σ|P| and a step's weight, J being the impulse of gravity, of applied forces and of immovable
  /// bodies; needs settings().audit_momentum from the start. Rounding is all that should remain.
  double momentum_error() const;

 private:
  std::unique_ptr<WorldState> state_;
};

}  // namespace cs550
