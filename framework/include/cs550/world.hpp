#pragma once
/// @file world.hpp
/// The world: bodies, and the step that combines the seven labs.

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

/// The contact solver to use.
enum class SolverKind : std::uint8_t {
  Naive,       ///< lab 6
  Constraint,  ///< lab 7
};

/// The directions of the solver's passes over the constraints.
enum class PassOrder : std::uint8_t {
  BackAndForth,  ///< every second pass of a substep goes backwards
  StepByStep,    ///< all passes of a step go one way, and those of the next step the other way
};

/// The settings of a world, which may be changed between steps. Lengths and speeds are multiples of
/// the length unit where noted. World::step() refuses numbers outside their ranges: those
/// without a range in their comment may be from 0 to 10⁶, a length unit and a stiffness from 10⁻⁶.
struct WorldSettings {
  Vec3 gravity = {0, 0, Real(-9.81)};  ///< m/s², each component up to 10⁶; the z axis points up
  /// The size of a typical body (m). It scales margins, slop and thresholds, but not the stiffness
  /// of contacts: bodies sink in in proportion to g/(2π·contact_hertz)², whatever their size.
  /// Bodies of a centimetre need ten times as many substeps as bodies of a metre, and ten times the
  /// stiffness.
  Real length_unit = 1;

  int substeps = 6;    ///< per step, 1–1000
  int iterations = 2;  ///< solver passes with bias per substep without impacts, 0–1000
  /// Relax passes (without bias) per substep of soft contacts, 0–1000; 1 counts as 2 where
  /// something bounces. With neither passes nor relax passes nothing corrects the impulses with
  /// which contacts start warm.
  int relax_iterations = 1;
  PassOrder pass_order = PassOrder::StepByStep;                ///< constraint solver only
  SolverKind solver = SolverKind::Constraint;                  ///< the contact solver
  ContactModel contact_model = ContactModel::Soft;             ///< how penetration is corrected
  RotationMethod rotation = RotationMethod::ImplicitMidpoint;  ///< how bodies are rotated
  bool warm_starting = true;  ///< start from the accumulated impulses of the last step
  /// Query a pair again only once its bodies have moved relative to each other. Depths then differ
  /// by at most 1/1000 of the smaller body's diameter.
  bool temporal_coherence = true;
  /// Skip groups of touching bodies that are at rest, until something disturbs them: another body,
  /// the program, or a setting that decides how bodies move.
  bool sleeping = false;
  /// Threads that share the work of a step, 1 to 16. Results are the same bits for any number, once
  /// all stages are written. With more than one, the functions of the labs are called by several
  /// threads at once.
  int threads = 1;
  /// Use several threads only while steps are faster with them. The world measures that now and
  /// then. If false, every step uses them, at most as many as the machine runs at once.
  bool adaptive_threads = true;

  /// Stiffness of soft contacts (1/s). At 80 a body on one of a twentieth of its mass never comes
  /// to rest: take more substeps.
  Real contact_hertz = 80;
  Real contact_damping_ratio = 12;  ///< ζ of soft contacts; 1 is critical
  Real baumgarte = Real(0.2);       ///< β, 0–1: fraction of the error corrected per substep
  Real slop = Real(1e-3);           ///< length units
  Real max_push_speed = 3;          ///< length units per second
  Real restitution_threshold = Real(0.5);  ///< length units per second
  /// Sweeps over impacts, 0–1000: apply_restitution(), Baumgarte's passes.
  int restitution_iterations = 8;
  /// ω of successive over-relaxation: relax passes change the normal impulse of a contact that the
  /// warm start loaded by ω times what would stop its approach. From 1 (none) to 1.9.
  Real over_relaxation = Real(1.3);
  /// Soft contacts with a warm start resist rolling and spinning with a torque of at most this
  /// lever (length units) times the normal force.
  Real rolling_resistance = 0;

  bool check_stages = false;    ///< check the postconditions of each stage
  bool audit_momentum = false;  ///< record what momentum_error() needs

  /// Whether all members are equal.
  bool operator==(const WorldSettings& other) const = default;
};

/// The named settings: how many passes a step takes, and how exact its result is.
enum class Quality : std::uint8_t {
  Accurate,  ///< the defaults of WorldSettings: the bounds of the tests hold
  Game,      ///< half as many substeps; no deeper penetration than Box3D's
};

/// Default settings with the members that a quality determines: substeps, iterations,
/// relax_iterations, pass_order, contact_hertz, contact_damping_ratio, over_relaxation,
/// rolling_resistance.
/// @{
WorldSettings accurate_settings();
WorldSettings game_settings();
/// @}

/// Sets the members that a quality determines. The others stay as they are.
void set_quality(WorldSettings& settings, Quality quality);
/// Whether these members have the values of a quality.
bool has_quality(const WorldSettings& settings, Quality quality);

/// Collision filtering: two bodies may touch if each body's mask contains a bit of the other's
/// category.
struct CollisionFilter {
  std::uint32_t category = 1;        ///< bits: the categories of this body
  std::uint32_t mask = 0xffffffffU;  ///< bits: the categories that it collides with
};

/// The definition of a new body.
struct BodyDef {
  BodyKind kind = BodyKind::Dynamic;  ///< how it moves
  ShapePtr shape;                     ///< required
  Real density = 1000;                ///< kg/m³
  std::optional<Real> mass;           ///< kg; overrides the density
  Pose pose;                          ///< initial, of the centre of mass (see source_origin)
  Vec3 linear_velocity = {0, 0, 0};   ///< initial, world (m/s)
  Vec3 angular_velocity = {0, 0, 0};  ///< initial, world (rad/s)
  Real friction = Real(0.6);          ///< μ; a pair uses the geometric mean
  Real restitution = 0;               ///< e; a pair uses the larger value
  CollisionFilter filter;             ///< the bodies that it may touch
};

/// Identifies a body during its lifetime. The id of a removed body is never reused.
struct BodyId {
  Index index = no_index;        ///< index in World::bodies()
  std::uint32_t generation = 0;  ///< number of earlier bodies at this index

  /// Whether both identify the same body.
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
/// The number of stages of a step.
inline constexpr int stage_count = 6;
/// The name of a stage, for display.
const char* to_string(Stage stage);

/// A stage that is not written yet or that violated a postcondition.
struct StageProblem {
  Stage stage = Stage::Integrate;  ///< the stage in which the problem was detected
  int lab = 0;                     ///< the lab that defines the function at fault
  Index body = no_index;           ///< the body at fault, if there is one
  std::int64_t step = 0;           ///< number of the step
  std::string message;             ///< "not implemented: L4.4 …", or the violated postcondition
};

/// Statistics of one step.
struct StepStats {
  std::array<double, stage_count> seconds{};  ///< per stage
  int pairs = 0;                              ///< from the broad phase
  int kept = 0;                               ///< pairs whose last answer still holds
  int retested = 0;                           ///< pairs whose last features proved to be right
  int contacts = 0;                           ///< pairs with a non-empty manifold
  int points = 0;                             ///< of all manifolds
  int asleep = 0;               ///< bodies; from the next step on, their pairs are not counted
  Real deepest_separation = 0;  ///< most negative separation, 0 if none (m)
};

/// Two bodies that began or ceased to touch.
struct ContactEvent {
  BodyId a;  ///< the body with the smaller index
  BodyId b;  ///< the other body
};

/// The first intersection of a ray with a body.
struct RayHit {
  BodyId body;              ///< the body that was hit
  Index face = no_index;    ///< of its mesh
  Real distance = 0;        ///< along the ray (m)
  Vec3 point = {0, 0, 0};   ///< world (m)
  Vec3 normal = {0, 0, 0};  ///< outward normal of the face, world
};

class AabbTree;
struct WorldState;

/// A simulation of rigid bodies. A plain value: a copy continues identically, so copying a world
/// saves and restores its state.
///
/// A stage that is not written yet is skipped and reported in problems(); the other stages still
/// run.
class World {
 public:
  /// An empty world at time 0.
  explicit World(const WorldSettings& settings = {});
  /// Copies and moves transfer the complete state. A world that was moved from can only be assigned
  /// to or destroyed.
  /// @{
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  /// @}
  ~World();

  /// The settings, which may be changed between steps.
  /// @{
  WorldSettings& settings();
  const WorldSettings& settings() const;
  /// @}

  /// Adds a body. May be called between steps. References to bodies, shapes and definitions, and
  /// what bodies() and contacts() returned, are invalid afterwards.
  /// @throws std::invalid_argument if the shape is missing, or if a number is not finite, has no
  ///         physical meaning or is out of range; the message names it. Speeds (m/s and rad/s) may
  ///         be up to 1e18, the mass up to 1e15 kg, the friction up to 1e6. For a radius r,
  ///         1/mass + r²/(smallest moment of inertia) may be up to 1e18/kg. The kinetic energy and
  ///         the square of the momentum must be finite
  BodyId add_body(const BodyDef& def);
  /// Removes a body and its contacts. May be called between steps. The id of a removed body is
  /// ignored. References to this body, its shape and its definition are invalid afterwards, those of
  /// others are not. What contacts(), sleeping_contacts() and axes() returned is invalid; what began()
  /// and ended() returned is not. After the next step ended() lists the pairs that touched.
  ///
  /// Takes time in proportion to all near pairs: remove_bodies() takes as long for any number of
  /// bodies. bodies() keeps its length, and every step visits all of it. The next body that is added
  /// takes the lowest free index.
  void remove_body(BodyId id);
  /// Removes several bodies at once. The world is then as if they had been removed one by one. An id
  /// may occur twice.
  void remove_bodies(std::span<const BodyId> ids);
  /// Replaces the definition of a body, including its pose and velocities: the way to change its
  /// kind, shape, mass, friction, restitution or filter. The body keeps its id and loses its
  /// contacts, which are found again in the next step: after it a pair may be in ended() and in
  /// began(). It invalidates what add_body() and remove_body() invalidate.
  /// @throws std::invalid_argument if the body is not alive, or as add_body() does; nothing has
  ///         changed then
  void redefine_body(BodyId id, const BodyDef& def);
  /// Whether the body has not been removed.
  bool is_alive(BodyId id) const;
  /// The number of bodies, without removed ones.
  int body_count() const;

  /// The body array, including the slots of removed bodies: check is_alive(id_at(i)).
  std::span<const RigidBody> bodies() const;
  /// The id of the body at an index of bodies(). @throws std::invalid_argument for another index
  BodyId id_at(Index index) const;
  /// A body.
  /// @throws std::invalid_argument if it is not alive
  const RigidBody& body(BodyId id) const;
  /// For applying forces and impulses (add_force(), apply_impulse()), and for giving any body
  /// another pose or velocity (set_velocity()). A kinematic body carries others by its velocity:
  /// one that is only given another pose moves from under them. Kind and mass stay as they were
  /// made (see redefine_body()), and the velocities of a dynamic body follow from its momenta in
  /// the next step. A body that sleeps wakes in that step, and from then on query() and ray_cast()
  /// find it at its new pose. Numbers must be finite: is_finite() checks poses and momenta.
  /// @throws std::invalid_argument if the body is not alive
  RigidBody& body(BodyId id);
  /// The definition of a body, with its initial pose; its shape; and its shape at the current pose.
  /// @throws std::invalid_argument if the body is not alive
  /// @{
  const ShapePtr& shape(BodyId id) const;
  const BodyDef& definition(BodyId id) const;
  PosedShape posed_shape(BodyId id) const;
  /// @}

  /// Advances the world by one step. What contacts(), sleeping_contacts(), axes(), began(), ended()
  /// and problems() returned is invalid afterwards.
  /// @param h s; 1/60 is usual. It may vary, and stored impulses follow, but piles rest best if it
  /// is constant.
  /// @throws std::invalid_argument if h is not finite or below 1e-30 s, or a setting is outside its
  ///         range; nothing has changed then
  /// @throws whatever a lab function throws, other than NotImplemented. The step is then incomplete:
  ///         go on from a copy that was made before.
  void step(Real h);
  std::int64_t step_count() const;  ///< steps since construction
  double time() const;              ///< simulated time (s)

  /// The pairs that the broad phase found, sorted by body. A pair touches if one of its points has
  /// a separation of at most 0 or has pushed in the last step. Normals, anchors and separations are
  /// those of the poses at the start of that step.
  std::span<const Contact> contacts() const;
  /// The pairs of bodies that are asleep, with each other and with bodies that do not move. They
  /// are not in contacts(). Whatever the length of later steps, their impulses are those of substeps
  /// as long as the last one was when the first of these pairs fell asleep.
  std::span<const Contact> sleeping_contacts() const;
  /// The axis of each pair of contacts(), in the same order, as the last query found it. With
  /// temporal_coherence that may have been in an earlier step.
  std::span<const SeparatingAxis> axes() const;
  std::span<const ContactEvent> began() const;  ///< pairs that began to touch in the last step
  /// Pairs that ceased to touch in the last step, or because a body was removed (check is_alive())
  /// or redefined before it. A redefined body may touch again: handle ended() before began().
  std::span<const ContactEvent> ended() const;
  const StepStats& stats() const;  ///< of the last step
  /// Missing stages of the last step and, with settings().check_stages, violated postconditions;
  /// empty in a finished engine.
  std::span<const StageProblem> problems() const;

  /// The nearest face that a ray hits from outside.
  /// @param origin world frame (m)
  /// @param direction world frame, any length but 0
  /// @param length m, 0 or more
  /// @throws std::invalid_argument if one of them is not finite (the length may be infinite) or
  ///         outside its range
  std::optional<RayHit> ray_cast(const Vec3& origin, const Vec3& direction, Real length) const;
  /// The bodies with bounds that overlap a box, sorted by index. Bounds() contains nothing.
  /// @throws std::invalid_argument if another box has a lower corner above its upper one, or is not
  ///         a number
  std::vector<BodyId> query(const Bounds& bounds) const;
  /// The tree of the broad phase, for drawing.
  const AabbTree& broad_phase() const;

  /// A hash of everything that one step leaves to the next, bit for bit (FNV-1a): poses, momenta,
  /// velocities of kinematic bodies, pending forces; the pairs with their contact points, impulses,
  /// hints and kept answers; the length of a substep; the parts of a world of many contacts; the
  /// boxes in the tree; with settings.sleeping, what decides when bodies fall asleep. Worlds with
  /// equal settings, definitions of bodies and hashes continue identically, up to a collision of
  /// 64-bit hashes.
  std::uint64_t state_hash() const;

  /// The momentum error |ΔP − J| over the run, relative to Σ|P| plus the weight that acts in one
  /// step. J is the impulse of gravity, of applied forces and of immovable bodies. Only rounding
  /// should remain. Requires settings().audit_momentum from the first step on; 0 without it.
  double momentum_error() const;

 private:
  std::unique_ptr<WorldState> state_;
};

}  // namespace cs550
