#include "pages/labs/body_pair.hpp"

namespace cs550::pages {

void describe(PairSettings& settings, ControlVisitor& visit) {
  visit.section("Bodies");
  visit.choice({"shape_a", "A", ""}, settings.shape_a, shape_names);
  visit.choice({"shape_b", "B", ""}, settings.shape_b, shape_names);
  visit.vector({"position", "position of B", "m"}, settings.position, 4);
  visit.vector({"turn", "rotation of B", "degrees"}, settings.turn, 180);
}

BodyPair::BodyPair(const PairSettings& settings)
    : shape_a(recorded_shape(settings.shape_a)),
      shape_b(recorded_shape(settings.shape_b)),
      a{shape_a.get(), {}},
      b{shape_b.get(), pose_from(settings.position, settings.turn)} {}

}  // namespace cs550::pages
