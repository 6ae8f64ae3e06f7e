#pragma once
/// @file world_state.hpp
/// What a world is made of, and the parts of its step. Everything here is copied with a world, so that
/// a copy continues identically.

#include <cstdint>
#include <vector>

#include "cs550/broad_phase.hpp"
#include "cs550/world.hpp"
#include "engine/contacts/solve_order.hpp"

namespace cs550 {

/// Place and life of one body in the arrays of the world.
struct BodySlot {
  std::uint32_t generation = 0;
  bool alive = false;
  Index leaf = no_index;  ///< in the tree
  Bounds swept_bounds;    ///< where its surface and contact margin may be during this step
};

/// The pairs that are near each other, sorted by (body_a, body_b), and what is remembered of each.
struct PairList {
  std::vector<Contact> contacts;
  std::vector<SeparatingAxis> axes;
  std::vector<char> touching;  ///< at the end of the last step

  std::size_t size() const { return contacts.size(); }
  void clear();
  /// Appends pair i of another list.
  void append(const PairList& other, std::size_t i);
};

/// Linear momentum that nothing explains, summed over the audited steps.
struct MomentumAudit {
  Eigen::Vector3d unexplained = Eigen::Vector3d::Zero();
  double largest_sum = 0;  ///< of |P| and weight·h over the bodies: the scale of the error
};

/// A pair of bodies without impulses to start from: its constraints, and one in their middle.
struct ColdPair {
  std::span<const Index> constraints;  ///< places in the array of constraints
  ContactConstraint middle;
};

struct WorldState {
  WorldSettings settings;

  std::vector<RigidBody> bodies;
  std::vector<BodyDef> definitions;
  std::vector<BodySlot> slots;
  int alive_count = 0;

  AabbTree tree;
  PairList pairs;

  std::vector<ContactEvent> began;
  std::vector<ContactEvent> ended;
  std::vector<ContactEvent> ended_by_removal;  ///< to be told with the next step
  std::vector<StageProblem> problems;
  StepStats stats;
  MomentumAudit audit;
  std::int64_t step_count = 0;
  double time = 0;

  // Room that a step works in, kept so that a warm step allocates nothing.
  std::vector<SolverBody> velocities;
  std::vector<ContactConstraint> constraints;
  SolveOrder solve_order;
  std::vector<ColdPair> cold_pairs;
  PairList next_pairs;
  std::vector<Index> moved;  ///< whose leaves moved since pairs were looked for
  std::vector<Index> found;
  std::vector<std::uint64_t> new_keys;
  std::vector<RigidBody> bodies_before;

  std::size_t slot_count() const { return slots.size(); }
  BodyId id_at(Index index) const {
    return {index, slots[static_cast<std::size_t>(index)].generation};
  }
  PosedShape posed_shape(Index index) const {
    const auto i = static_cast<std::size_t>(index);
    return {definitions[i].shape.get(), bodies[i].pose};
  }
  Real slop() const { return settings.slop * settings.length_unit; }
};

/// The margin within which two surfaces get contact points during a step of length h (m): what
/// they may close at their present speeds and in free fall, and a few slops.
Real contact_margin(const WorldState& world, Index body_a, Index body_b, Real h);

/// Gives a new body its leaf in the tree.
void insert_leaf(WorldState& world, Index body);
/// Makes every leaf hold its body as it is now, so that queries between steps find it.
void enclose_bodies(WorldState& world);
/// Brings the tree and the pairs up to date with poses and speeds. @param h step (s)
void update_pairs(WorldState& world, Real h);
/// Drops the pairs of a body that is being removed; those that touched go to ended_by_removal.
void remove_pairs_of(WorldState& world, Index body);

/// Copies what solvers see of the bodies. Displacements are kept.
void gather_solver_bodies(const WorldState& world, std::span<SolverBody> velocities);
/// Gives the bodies the momenta that belong to the solved velocities. Only the change is written,
/// so that a body without contacts keeps P and L to the last bit.
void write_back_momenta(WorldState& world);

/// Fills one constraint per contact point.
void make_constraints(WorldState& world);
/// Calls `visit(contact, places)` for every contact, with the places of its points' constraints in the array.
/// @pre solve_order is that of the present contact points
template <class Visit>
void for_constraints_of_contacts(WorldState& world, const Visit& visit) {
  const Index* place = world.solve_order.place_of_point.data();
  for (Contact& contact : world.pairs.contacts) {
    const auto points = static_cast<std::size_t>(contact.manifold.points.size());
    visit(contact, std::span<const Index>(place, points));
    place += points;
  }
}
/// Prepares the constraints of bodies anew that have turned far since the step began: their inertia in the
/// world has changed.
void refresh_masses(WorldState& world, const ContactStep& step);
/// Gives constraints that are new and at rest the impulses that they will need. @param h substep (s)
void guess_cold_impulses(WorldState& world, Real h);
/// Hands the accumulated impulses back to the contact points, for the next step's warm start.
void store_impulses(WorldState& world);

/// What a stage promised (rule 5): breaches are reported in problems() and their effect undone.
void check_bodies(WorldState& world);
void check_axes(WorldState& world);
void check_manifolds(WorldState& world);

/// integrate_pose() and refresh_velocity(), with a guard against turns that the midpoint cannot
/// follow. @param h substep (s) @pre velocities are fresh
void turn_and_move(RigidBody& body, Real h, RotationMethod method);

/// One step, stage by stage (stages.hpp). @param h s
void advance(WorldState& world, Real h);

/// Impulses of one substep that come from outside the dynamic bodies: forces over h, and the constraints
/// that push against immovable bodies (N·s).
Eigen::Vector3d outer_impulse(const WorldState& world, Real h);
/// Σ P of the dynamic bodies, in double.
Eigen::Vector3d total_momentum(const WorldState& world);

}  // namespace cs550
