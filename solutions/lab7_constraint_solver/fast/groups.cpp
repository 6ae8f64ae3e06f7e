#include "groups.hpp"

namespace cs550 {

namespace {

/// Forms the groups, one pair of bodies after the other.
class Grouping {
 public:
  Grouping(std::span<const ContactConstraint> constraints, std::span<const SolverBody> bodies,
           ConstraintMirror& mirror)
      : constraints_(constraints), bodies_(bodies), mirror_(mirror) {
    mirror_.last_group.assign(bodies.size(), no_index);
  }

  /// The next group: as many consecutive constraints as possible make its first row.
  PairGroup take() {
    PairGroup group;
    group.bodies_a.fill(no_index);
    group.bodies_b.fill(no_index);
    lanes_ = 0;
    while (!done() && lanes_ < lane_count && !is_taken(next().body_a) && !is_taken(next().body_b) &&
           (lanes_ == 0 || !is_start(next_))) {
      take_body(next().body_a);
      take_body(next().body_b);
      group.bodies_a[lanes_] = next().body_a;
      group.bodies_b[lanes_] = next().body_b;
      group.has_immovable =
          group.has_immovable || is_immovable(next().body_a) || is_immovable(next().body_b);
      ++lanes_;
      ++next_;
    }
    return group;
  }

  /// The next row of the group: the constraints that follow belong to its pairs, lane by lane.
  /// @returns how many
  Index take_row(const PairGroup& group) {
    std::size_t lane = 0;
    while (!done() && lane < lanes_ && !is_start(next_) && next().body_a == group.bodies_a[lane] &&
           next().body_b == group.bodies_b[lane]) {
      ++lane;
      ++next_;
    }
    return static_cast<Index>(lane);
  }

  bool done() const { return next_ == constraints_.size(); }
  Index taken() const { return static_cast<Index>(next_); }
  Index lanes() const { return static_cast<Index>(lanes_); }

 private:
  const ContactConstraint& next() const { return constraints_[next_]; }

  /// @pre called with ascending indices
  bool is_start(std::size_t constraint) {
    const std::vector<Index>& starts = mirror_.starts;
    while (start_ < starts.size() && static_cast<std::size_t>(starts[start_]) < constraint)
      ++start_;
    return start_ < starts.size() && static_cast<std::size_t>(starts[start_]) == constraint;
  }
  Index group() const { return static_cast<Index>(mirror_.groups.size()); }
  bool is_taken(Index body) const { return mirror_.last_group[body] == group(); }
  bool is_immovable(Index body) const { return bodies_[body].inverse_mass == 0; }
  void take_body(Index body) {
    if (bodies_[body].inverse_mass > 0) mirror_.last_group[body] = group();
  }

  std::span<const ContactConstraint> constraints_;
  std::span<const SolverBody> bodies_;
  ConstraintMirror& mirror_;
  std::size_t next_ = 0;
  std::size_t lanes_ = 0;
  std::size_t start_ = 0;  ///< the next one of the mirror's
};

}  // namespace

void find_groups(std::span<const ContactConstraint> constraints, std::span<const SolverBody> bodies,
                 ConstraintMirror& mirror) {
  mirror.groups.clear();
  mirror.rows.clear();
  Grouping grouping(constraints, bodies, mirror);
  while (!grouping.done()) {
    ConstraintRow row{grouping.taken(), 0};
    PairGroup group = grouping.take();
    group.first_row = static_cast<Index>(mirror.rows.size());
    for (row.count = grouping.lanes(); row.count > 0; row.count = grouping.take_row(group)) {
      mirror.rows.push_back(row);
      row.first += row.count;
    }
    group.row_count = static_cast<Index>(mirror.rows.size()) - group.first_row;
    mirror.groups.push_back(group);
  }
}

}  // namespace cs550
