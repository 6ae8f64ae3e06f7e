#pragma once
/// @file passes.hpp
/// Passes over the rows of the mirror. Two source files include it, one for each width of register.
///
/// Bodies stay in registers while the rows of a group are solved. Eight chains of dependent
/// operations then run at once. Each of them alone would leave the processor waiting most of the time.

#include "engine/contacts/contact_passes.hpp"
#include "groups.hpp"
#include "kernels.hpp"
#include "wide_contact.hpp"

namespace cs550::CS550_LANES {

/// The bodies of a group. An unused lane holds a body of its own, at rest.
class GroupBodies {
 public:
  GroupBodies(const PairGroup& group, std::span<SolverBody> bodies)
      : has_immovable_(group.has_immovable) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const bool used = group.bodies_a[lane] != no_index;
      a_[lane] = used ? &bodies[group.bodies_a[lane]] : &at_rest_;
      b_[lane] = used ? &bodies[group.bodies_b[lane]] : &at_rest_;
    }
  }
  GroupBodies(const GroupBodies&) = delete;
  GroupBodies& operator=(const GroupBodies&) = delete;

  /// Lets the lanes of immovable bodies be stored elsewhere: other threads may read these bodies.
  void spare_immovable() {
    if (!has_immovable_) return;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if (a_[lane]->inverse_mass == 0) a_[lane] = &at_rest_;
      if (b_[lane]->inverse_mass == 0) b_[lane] = &at_rest_;
    }
  }

  const PerLane<SolverBody>& a() const { return a_; }
  const PerLane<SolverBody>& b() const { return b_; }

  WidePair load() const { return {WideBody(a_), WideBody(b_)}; }
  void store(const WidePair& pair) {
    spare_immovable();
    pair.a.store_velocities(a_);
    pair.b.store_velocities(b_);
  }

 private:
  bool has_immovable_ = false;
  PerLane<SolverBody> a_;
  PerLane<SolverBody> b_;
  SolverBody at_rest_;
};

inline std::span<WideConstraint> rows_of(const PairGroup& group, ConstraintMirror& mirror) {
  return wide_constraints(mirror).subspan(group.first_row, group.row_count);
}

/// Calls `visit(row, constraints)` for every row. Unused lanes have an idle constraint.
template <class Visit>
void for_rows(std::span<ContactConstraint> constraints, ConstraintMirror& mirror,
              const Visit& visit) {
  ContactConstraint idle;
  for (std::size_t i = 0; i < mirror.rows.size(); ++i) {
    visit(wide_constraints(mirror)[i], lanes_of(constraints, mirror.rows[i], idle));
  }
}

inline void warm_start_all(ConstraintMirror& mirror, std::span<SolverBody> bodies) {
  for (const PairGroup& group : mirror.groups) {
    GroupBodies group_bodies(group, bodies);
    WidePair pair = group_bodies.load();
    for (WideConstraint& constraint : rows_of(group, mirror)) warm_start(constraint, pair);
    group_bodies.store(pair);
  }
}

/// solve_contacts().
[[gnu::flatten]] inline void solve_forwards(ConstraintMirror& mirror, std::span<SolverBody> bodies,
                                            const ContactStep& step, const Passes& pass) {
  for (const PairGroup& group : mirror.groups) {
    GroupBodies group_bodies(group, bodies);
    WidePair pair = group_bodies.load();
    for (WideConstraint& constraint : rows_of(group, mirror)) {
      solve_normal(constraint, pair, step, pass.over_relaxation);
      solve_friction(constraint, pair);
      if (pass.mark_impacts) mark_impacts(constraint);
    }
    group_bodies.store(pair);
  }
}

/// solve_contacts() with step.backwards.
[[gnu::flatten]] inline void solve_backwards(ConstraintMirror& mirror, std::span<SolverBody> bodies,
                                             const ContactStep& step, const Passes& pass) {
  for (auto group = mirror.groups.rbegin(); group != mirror.groups.rend(); ++group) {
    GroupBodies group_bodies(*group, bodies);
    WidePair pair = group_bodies.load();
    const std::span<WideConstraint> rows = rows_of(*group, mirror);
    for (auto constraint = rows.rbegin(); constraint != rows.rend(); ++constraint) {
      solve_friction(*constraint, pair);
      solve_normal(*constraint, pair, step, pass.over_relaxation);
      if (pass.mark_impacts) mark_impacts(*constraint);
    }
    group_bodies.store(pair);
  }
}

/// run_passes().
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes) {
  if (mirror.stale) {
    find_groups(constraints, bodies, mirror);
    mirror.numbers.resize(mirror.rows.size() * lines_per_row);
    for (WideConstraint& row : wide_constraints(mirror)) row.flags = all_lanes(0);
    mirror.stale = false;
    mirror.stale_numbers = true;
    mirror.is_ahead = false;
  }
  if (mirror.stale_numbers) {
    for_rows(constraints, mirror,
             [](WideConstraint& row, const auto& lanes) { copy_constants(lanes, row); });
    mirror.stale_numbers = false;
    mirror.stale_impulses = true;
  }
  if (mirror.stale_impulses) {
    for_rows(constraints, mirror,
             [](WideConstraint& row, const auto& lanes) { load_impulses(lanes, row); });
    mirror.stale_impulses = false;
  }
  if (passes.warm_start) warm_start_all(mirror, bodies);
  for (int i = 0; i < passes.count; ++i) {
    const Passes pass = passes.one(i);
    if (pass.backwards) {
      solve_backwards(mirror, bodies, step, pass);
    } else {
      solve_forwards(mirror, bodies, step, pass);
    }
  }
  if (passes.count == 0 && passes.mark_impacts) {
    for (WideConstraint& row : wide_constraints(mirror)) mark_impacts(row);
  }
  mirror.is_ahead = mirror.is_ahead || passes.count > 0 || passes.mark_impacts;
  if (!passes.store || !mirror.is_ahead) return;
  for_rows(constraints, mirror,
           [](const WideConstraint& row, const auto& lanes) { store_impulses(row, lanes); });
  mirror.is_ahead = false;
}

}  // namespace cs550::CS550_LANES
