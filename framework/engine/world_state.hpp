#pragma once
/// @file world_state.hpp
/// What a world consists of. All of it is copied with the world, so that a copy continues
/// identically.

#include <array>
#include <bitset>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "cs550/broad_phase.hpp"
#include "cs550/static_vector.hpp"
#include "cs550/world.hpp"
#include "engine/constraint_mirror.hpp"
#include "engine/passes.hpp"
#include "engine/threads/thread_team.hpp"
#include "engine/threads/thread_trial.hpp"

namespace cs550 {

/// What the world knows about the body at one index of its arrays.
struct BodySlot {
  std::uint32_t generation = 0;
  bool alive = false;
  Index leaf = no_index;  ///< in the tree
  Bounds swept_bounds;    ///< where its surface and contact margin may be during this step
  Real radius = 0;        ///< of its shape (m)
  Real spin_speed = 0;    ///< of its surface by rotation, at most, when the step begins (m/s)
};

/// The bounds of a body's shape at a pose.
struct BodyBounds {
  Pose pose;
  Bounds bounds;
};

/// What is kept of a pair's last query. It decides how long the answer holds. In the frame of the
/// body that owns the manifold's reference feature: B for a face of B, otherwise A.
struct PairMemory {
  Pose smaller_in_larger;    ///< the body of smaller radius, seen from the other
  Real margin = 0;           ///< features farther apart got no contact points (m)
  Plane plane;               ///< through the anchors on the owner, with the manifold's normal
  Vec3 tangent = {0, 0, 0};  ///< of the manifold
};

/// How a step got the axis and the manifold of a pair.
enum class PairAnswer : std::uint8_t {
  Queried,   ///< by a full query
  Kept,      ///< the last answer still holds, see answer_holds()
  Retested,  ///< from the last features alone, see retest_features()
};

/// What the loops over all pairs need of a contact. Most pairs are only near, and all contacts together do not fit
/// the cache.
struct PairSummary {
  Index body_a = no_index;
  Index body_b = no_index;
  Index points = 0;      ///< of the manifold
  Real depth = 0;        ///< of the deepest point; 0 if none is below the surface (m)
  bool bounces = false;  ///< whether the contact has restitution
};

/// Pairs that stay neighbours while a list is edited: those from `first` to before `last` go to `to`.
struct PairStretch {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t to = 0;
};

/// A pair that an edit inserts.
struct InsertedPair {
  std::size_t to = 0;
  std::uint64_t key = 0;  ///< see pair_key()
};

/// Working storage of a search for new pairs.
struct PairSearch {
  std::vector<Index> found;
  std::vector<std::uint64_t> keys;  ///< of the new pairs
};

/// The pairs of bodies that are near each other, sorted by (body_a, body_b), with what is kept of
/// each from step to step.
struct PairList {
  std::vector<Contact> contacts;
  std::vector<PairSummary> summaries;  ///< of each contact, see summarise()
  std::vector<SeparatingAxis> axes;    ///< of the last query
  std::vector<PairMemory> memories;    ///< of the last query
  std::vector<PairAnswer> answers;     ///< of this step
  std::vector<char> touching;          ///< at the end of the last step
  std::vector<double> impulse_energy;  ///< of the impulses that the contact points keep (J)
  std::vector<char> misplaced;         ///< overlaps more deeply than the bodies can have moved

  // Working storage of PairListEdit.
  std::vector<PairStretch> stretches;
  std::vector<InsertedPair> inserted;

  std::size_t size() const { return contacts.size(); }
  bool has_points(std::size_t pair) const { return summaries[pair].points > 0; }
  /// Brings a pair's summary up to date. Call it after each change of its contact points.
  void summarise(std::size_t pair);
  void clear();
  /// Makes room for that many pairs, or for twice as many if there is not enough.
  void make_room(std::size_t count);
  /// Appends a pair of another list.
  void append(const PairList& other, std::size_t i);
};

/// What decides whether a body is at rest. A window of time begins with each larger displacement.
struct BodyRest {
  Pose start;               ///< when the window began; of an immovable body, one step ago
  Pose middle;              ///< half a window later
  Real first_half = 0;      ///< displacement between the two (m)
  Real time = 0;            ///< since the window began (s)
  bool settled = false;     ///< whether the last whole window was quiet, and all since
  Index island = no_index;  ///< while asleep: the smallest index of the bodies in its island
};

/// A body as the last step left it: the program has changed it since if it is another.
struct LeftBody {
  Pose pose;
  Vec3 linear_momentum = {0, 0, 0};
  Vec3 angular_momentum = {0, 0, 0};
};

/// What is kept of sleeping bodies, and the working storage that finds them.
struct Sleeping {
  std::vector<BodyRest> bodies;
  std::vector<LeftBody> left;  ///< of dynamic bodies that are awake
  PairList pairs;  ///< of sleeping bodies, among themselves and with immovable ones at rest
  Real substep_length = 0;        ///< for which the impulses of these pairs are (s)
  WorldSettings settings;         ///< with which they fell asleep
  std::vector<char> wakes;        ///< of each island, by its smallest index
  std::vector<char> moved_pairs;  ///< of one list to the other
  std::vector<Index> island_of;   ///< see find_resting_islands()
  std::vector<Index> parent;      ///< of each body, in the forest of union-find
  std::vector<char> stays_awake;  ///< of each root
  std::vector<char> supported;    ///< of each root: touches an immovable body
};

/// Linear momentum that no outer impulse explains, summed over the audited steps.
struct MomentumAudit {
  Eigen::Vector3d unexplained = Eigen::Vector3d::Zero();
  double largest_sum = 0;  ///< of |P| and weight·h over the bodies: the scale of the error
};

/// Stages that are skipped until the step ends, since a lab function that they call is not written
/// yet.
class UnwrittenStages {
 public:
  bool contains(Stage stage) const { return stages_[static_cast<std::size_t>(stage)]; }
  bool any() const { return stages_.any(); }
  void add(Stage stage) { stages_.set(static_cast<std::size_t>(stage)); }
  void clear() { stages_.reset(); }

 private:
  std::bitset<stage_count> stages_;
};

inline constexpr Index most_parts = 8;

/// The positions of a contact's bodies, where that of an immovable one is the position of the other (world).
struct ContactEnds {
  Vec3 a, b;
};

/// The parts of the world, see divide_bodies(); and the numbers of the bodies, see PartNumbering.
struct BodyParts {
  Index count = 1;
  std::vector<Index> of_body;     ///< the part of each body
  Vec3 direction = Vec3::Zero();  ///< from part to part, in the world frame
  int age = 0;  ///< steps since the bodies were divided, if there are several parts

  bool renumbered = false;                    ///< whether the bodies are numbered part by part now
  bool any_kinematic = false;                 ///< whether one of the numbered bodies is
  std::vector<Index> numbers;                 ///< of each body; empty once they are divided again
  std::vector<Index> bodies_by_number;        ///< of each number
  std::array<Index, most_parts + 1> first{};  ///< number of each part, and the number of bodies
  // Working storage:
  std::vector<RigidBody> other_bodies;  ///< the world's in the other order
  std::vector<ContactEnds> contacts;    ///< with points

  /// Where the arrays of a substep have a body.
  Index number_of(Index body) const { return renumbered ? numbers[body] : body; }
};

/// Contacts that are solved side by side, by their index in the list.
using ContactGroup = StaticVector<Index, lane_count>;

/// What the solve order depends on: a contact with points, and the bodies that tie it to others.
struct ContactLink {
  Index contact = no_index;
  Index body_a = no_index;  ///< no_index if the body is immovable
  Index body_b = no_index;  ///< no_index if the body is immovable
  Index points = 0;
  Index unit = 0;  ///< of the solve order

  bool operator==(const ContactLink&) const = default;
};

/// Links in the order of the pairs, and what the solve order sorts them by.
struct RankedLinks {
  std::vector<ContactLink> links;
  std::vector<Index> ranks;
  Index parts = 1;  ///< of the world

  bool operator==(const RankedLinks&) const = default;
};

/// Neighbours among the sorted links that may be solved from either end (row_order.hpp).
struct LinkRow {
  std::size_t first = 0;
  std::size_t count = 0;
  Index part = 0;
  bool turned = false;
};

/// Working storage of the schedule, for each link.
struct LinkState {
  Index waits_for = 0;  ///< links that must come before and have no group yet
  Index chain = 0;      ///< cost of the longest chain that begins with this one: see form_groups()
  std::array<Index, 2> followers = {no_index, no_index};  ///< the next link of each body
  Index below = no_index;  ///< the next link of a stack of ready ones
};

/// The links that wait for no other, in a stack for each cost of the chains that they begin.
struct ReadyLinks {
  std::vector<Index> tops;  ///< of each cost, the link on top
  Index longest = 0;        ///< cost of the longest chain; the stacks above it are empty
  std::size_t count = 0;
};

/// Contacts that one thread solves in turn: those of a part, or those between parts.
struct SolveUnit {
  Index first_contact = 0;  ///< in the list of contacts with points
  Index first_across = 0;   ///< of a part, in that list: normals from here on are across gravity
  Index end_contact = 0;
  Index first_place = 0;  ///< of the constraints
  Index end_place = 0;
  std::vector<ContactGroup> groups;
  // Working storage of form_groups(), for each unit, since several threads that write to one array wait for each other:
  std::array<ReadyLinks, max_manifold_points> ready;  ///< by number of points
  std::vector<Index> next_of_body;                    ///< the next link of each body
};

/// Units of a phase share no movable body. A phase waits for the one before it.
inline constexpr std::size_t phase_count = 4;
/// Inside parts, between neighbours in two phases, and between parts that are not neighbours.
inline constexpr std::size_t most_units = most_parts + (most_parts - 1) + 1;

/// The index of the constraint of each contact point, with the points of all contacts counted in
/// turn; and the working storage of arrange_constraints().
struct SolveOrder {
  std::vector<Index> place_of_point;
  std::vector<Index> first_point;  ///< of each contact, and the number of all points
  std::vector<Index> contacts;     ///< those with points

  /// The indices of a contact's constraints, in the order of its points.
  std::span<const Index> places_of(Index contact) const {
    return std::span(place_of_point)
        .subspan(first_point[contact], first_point[contact + 1] - first_point[contact]);
  }

  std::vector<SolveUnit> units;
  std::array<std::size_t, phase_count + 1> phases{};  ///< first unit of each, and number of units
  RankedLinks unsorted;            ///< working storage: those of the present contacts
  RankedLinks sorted_from;         ///< those that were sorted into `links`
  std::vector<ContactLink> links;  ///< sorted by rank and colour, with the rows as they are turned
  std::vector<LinkRow> rows;       ///< of all parts
  std::vector<Index> with_points;  ///< working storage: contacts in the order of the pairs
  std::vector<Index> ranks;        ///< working storage: ranks with colours
  std::vector<LinkState> states;
  std::vector<unsigned> colours_of_body;  ///< a bit for each colour of its links between parts
};

/// What a substep does to a part of the world, or to a unit of contacts.
enum class PartWork : std::uint8_t {
  ApplyForces,  ///< those of the substep, to momenta
  RefreshMasses,
  BiasedPasses,
  ResistRolling,
  Move,
  RefreshThinMasses,
  RelaxPasses,
  KeepMomenta,  ///< those that the relax passes gave
};

/// Work for all units of a phase, see run_substeps_by_part().
struct PartTask {
  PartWork work = PartWork::ApplyForces;
  std::size_t phase = 0;  ///< of the solve order; its units of phase 0 are the parts
  Passes passes;
};

/// What a body's mass and inertia say about its shape.
struct BodySize {
  /// tr I · tr I⁻¹: 9 for a cube, 2500 for a needle of 1 : 50. A needle that turns by its thinness, one over the root of
  /// this, moves its ends by half its thickness: the lever of a contact there about the needle's axis, and with it the
  /// effective mass, is another one.
  Real squared_slenderness = 1;
  /// A cube of 1 m is 1.4 m long by this measure (m²). Immovable bodies have no limit.
  Real squared_length = HUGE_VALF;
};

/// How far a body has turned, in terms of what a turn changes about its contacts.
enum class TurnSize : char {
  Small,
  Far,           ///< their effective masses
  PastThinness,  ///< their levers, too
};

/// A pair of bodies without impulses from the last step.
struct ColdPair {
  Index contact = no_index;
  ContactConstraint middle;  ///< one constraint in the middle of those of the contact
};

/// Working storage of guess_cold_impulses().
struct ColdStart {
  std::vector<char> is_pair_cold;  ///< of each contact, see note_if_cold()
  std::vector<ColdPair> pairs;
  std::vector<char> is_cold;       ///< of each body, whether it is movable and of a pair
  std::vector<SolverBody> bodies;  ///< with the velocities that gravity and the impulses give them
};

/// The bodies of a step that recover from overlap, and the state to which they return after a push.
struct OverlapRecovery {
  bool any = false;
  std::vector<char> recovers;  ///< of each body
  std::vector<Index> parent;   ///< of each body, in the forest of those that touch
  std::vector<RigidBody> bodies;
  std::vector<ContactConstraint> constraints;
};

/// The kinetic energy of bodies that contacts connect (J): start + linear·s + square·s² with the part s of
/// the impulses of relax passes and restitution.
struct ImpactGroup {
  double before = 0;  ///< before the contacts acted
  double after = 0;   ///< with all impulses
  double start = 0;
  double linear = 0;
  double square = 0;
  bool is_pushed = false;  ///< by a moving kinematic body
};

/// The impacts of a substep that bounce, and the working storage of limit_impact_energy().
struct Impacts {
  bool any = false;
  std::vector<double> energy_before;  ///< of each body (J)
  std::vector<SolverBody> bodies;     ///< when the relax passes begin
  std::vector<Vec3> impulses;         ///< of each constraint by then: along n, u and v (N·s)
  std::vector<Index> parent;          ///< of each body, in the forest of union-find
  std::vector<ImpactGroup> groups;    ///< of each root
};

struct WorldState {
  WorldSettings settings;
  ThreadTeam* team = nullptr;  ///< during a step with several threads
  ThreadTrial thread_trial;

  std::vector<RigidBody> bodies;
  std::vector<BodyDef> definitions;
  std::vector<BodySlot> slots;
  int alive_count = 0;
  std::size_t first_free = 0;  ///< no index below is free

  AabbTree tree;
  std::vector<BodyBounds> bounds;  ///< of each body, see present_bounds()
  PairList pairs;
  Sleeping sleeping;

  std::vector<ContactEvent> began;
  std::vector<ContactEvent> ended;
  std::vector<ContactEvent> ended_by_removal;  ///< reported with the next step
  std::vector<StageProblem> problems;
  UnwrittenStages unwritten;
  StepStats stats;
  MomentumAudit audit;
  MomentumAudit audit_before;  ///< this step
  std::int64_t step_count = 0;
  double time = 0;
  Real substep_length = 0;  ///< of the last step (s), for which the contact points' impulses are

  // Working storage of a step, kept so that a steady-state step does not allocate.
  std::vector<SolverBody> solver_bodies;
  std::vector<ContactConstraint> constraints;
  std::vector<char> touches;  ///< of each pair, see is_touching()
  bool any_bounces = false;   ///< whether a constraint has restitution
  ConstraintMirrors mirrors;
  std::vector<TurnSize> turns;             ///< of each body, since the step began
  std::vector<TurnSize> turns_in_substep;  ///< of each body
  std::vector<BodySize> sizes;             ///< of each body
  BodyParts parts;
  SolveOrder solve_order;
  std::vector<PartTask> tasks;  ///< of a substep
  ColdStart cold_start;
  OverlapRecovery recovery;
  Impacts impacts;
  PairList next_pairs;
  std::vector<char> leaving;    ///< of each body, whether it is being removed
  std::vector<char> outgrown;   ///< of each body, whether it has left its leaf's box
  std::vector<Index> moved;     ///< bodies whose leaves have moved since the last search for pairs
  std::vector<char> has_moved;  ///< of each body, whether it is one of these
  std::vector<Bounds>
      searched_bounds;  ///< of each body's leaf at the last search; empty before the first
  std::vector<PairSearch> searches;  ///< of some bodies each
  std::vector<std::uint64_t> new_keys;
  std::vector<RigidBody> bodies_before;

  std::size_t slot_count() const { return slots.size(); }
  BodyId id_at(Index index) const { return {index, slots[index].generation}; }
  PosedShape posed_shape(Index index) const {
    return {definitions[index].shape.get(), bodies[index].pose};
  }
  Real slop() const { return settings.slop * settings.length_unit; }
};

/// The bodies of a block: so few that the next sweep still finds in the nearest cache what the last one left there.
inline constexpr std::size_t few_bodies = 32;

/// Calls `work(first, last)` for a few bodies at a time.
template <class Work>
void for_few_bodies(std::size_t first, std::size_t last, const Work& work) {
  for (; first < last; first += few_bodies) work(first, std::min(first + few_bodies, last));
}

/// The same for all bodies, by several threads if there are any. `work` may change only its own bodies and what
/// belongs to them. If the bodies are numbered part by part, each part is taken by one thread.
/// The grader's worker has the bodies alone, without their slots.
template <class Work>
void for_body_blocks(const WorldState& world, const Work& work) {
  if (const BodyParts& parts = world.parts; parts.renumbered) {
    const auto count = static_cast<std::size_t>(parts.count);
    for_blocks(world.team, count, 1, [&](std::size_t first, std::size_t last) {
      for_few_bodies(static_cast<std::size_t>(parts.first[first]),
                     static_cast<std::size_t>(parts.first[last]), work);
    });
    return;
  }
  for_blocks(world.team, world.bodies.size(), few_bodies,
             [&](std::size_t first, std::size_t last) { for_few_bodies(first, last, work); });
}

/// Calls `work(bodies, solver_bodies)` for the same blocks of both arrays.
template <class Work>
void for_solver_body_blocks(WorldState& world, const Work& work) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    work(std::span(world.bodies).subspan(first, last - first),
         std::span(world.solver_bodies).subspan(first, last - first));
  });
}

/// Calls `work(first, last)` for blocks of pairs that cost little each. Several threads share them if there are any.
template <class Work>
void for_pair_blocks(const WorldState& world, const Work& work) {
  constexpr std::size_t many_pairs = 256;
  for_blocks(world.team, world.pairs.size(), many_pairs, work);
}

/// Visits the dynamic bodies, those that are asleep, too.
template <class State, class Visit>
void for_dynamic_bodies(State& world, const Visit& visit) {
  for (auto& body : world.bodies) {
    if (body.kind == BodyKind::Dynamic) visit(body);
  }
}

}  // namespace cs550
