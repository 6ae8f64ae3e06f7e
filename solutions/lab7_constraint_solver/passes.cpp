#include "cs550/constraint_solver.hpp"

namespace cs550 {

void solve_contacts(std::span<ContactRow> rows, std::span<BodyVelocity> bodies,
                    const ContactStep& step) {
  const auto body = [&](Index i) -> BodyVelocity& { return bodies[static_cast<std::size_t>(i)]; };
  if (step.backwards) {
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      solve_friction(*row, body(row->body_a), body(row->body_b));
      solve_normal(*row, body(row->body_a), body(row->body_b), step);
    }
  } else {
    for (ContactRow& row : rows) {
      solve_normal(row, body(row.body_a), body(row.body_b), step);
      solve_friction(row, body(row.body_a), body(row.body_b));
    }
  }
}

}  // namespace cs550
