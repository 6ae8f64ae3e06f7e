#include "pages/labs/body_pair.hpp"

namespace cs550::pages {
namespace {

constexpr Real farthest = 4;  ///< m, each coordinate of a position

}  // namespace

void describe(PairSettings& settings, ControlVisitor& visit) {
  visit.section("Bodies");
  visit.choice({"shape_a", "A", ""}, settings.shape_a, shape_names);
  visit.choice({"shape_b", "B", ""}, settings.shape_b, shape_names);
  visit.vector({"position", "position of B", "m"}, settings.position, farthest);
  visit.vector({"turn", "rotation of B", "degrees"}, settings.turn, 180);
  visit.vector({"position_a", "position of A", "m"}, settings.position_a, farthest);
  visit.vector({"turn_a", "rotation of A", "degrees"}, settings.turn_a, 180);
}

std::vector<Handle> handles(const PairSettings& settings) {
  return {{"A", settings.position_a, true}, {"B", settings.position, true}};
}

void move_handle(PairSettings& settings, std::size_t handle, const Vec3& point) {
  Vec3& position = handle == 0 ? settings.position_a : settings.position;
  position = point.cwiseMax(-farthest).cwiseMin(farthest);
}

void turn_handle(PairSettings& settings, std::size_t handle, const Vec3& rotation) {
  Vec3& turn = handle == 0 ? settings.turn_a : settings.turn;
  turn = turn_degrees(rotation_exp(rotation) * pose_from(Vec3::Zero(), turn).orientation);
}

BodyPair::BodyPair(const PairSettings& settings)
    : shape_a(recorded_shape(settings.shape_a)),
      shape_b(recorded_shape(settings.shape_b)),
      a{shape_a.get(), pose_from(settings.position_a, settings.turn_a)},
      b{shape_b.get(), pose_from(settings.position, settings.turn)} {}

}  // namespace cs550::pages
