#include "engine/scenes/scene_bodies.hpp"

#include <algorithm>

namespace cs550 {
namespace {

constexpr Real degree = pi / 180;
constexpr std::size_t longest_name = 200;  // generators copy it into each of their bodies

Quat about(const Vec3& axis, Real degrees) {
  return rotation_exp(degrees * degree * axis.normalized());
}

const char* orientation_example = R"({"axis": [0, 0, 1], "degrees": 45})";

Quat read_quaternion(SceneReader& orientation) {
  const auto items = orientation.list("quaternion", "[1, 0, 0, 0]");
  const auto number = [](const auto& item) { return SceneReader::is_number(*item.first); };
  Quat q = Quat::Identity();
  const bool four = items.size() == 4 && std::all_of(items.begin(), items.end(), number);
  if (four) {
    q = Quat(items[0].first->template get<Real>(), items[1].first->template get<Real>(),
             items[2].first->template get<Real>(), items[3].first->template get<Real>());
  }
  if (!four || !(std::abs(q.norm() - 1) < Real(1e-2))) {
    orientation.refuse("quaternion", "the four numbers w, x, y, z of a unit quaternion",
                       "[1, 0, 0, 0]");
  }
  return q.normalized();
}

/// One of three ways to say it: a quaternion, an axis and an angle, or three angles.
Quat read_orientation(SceneReader orientation) {
  Quat q = Quat::Identity();
  if (orientation.has("quaternion")) {
    q = read_quaternion(orientation);
  } else if (orientation.has("axis")) {
    Vec3 axis = Vec3::UnitZ();
    Real degrees = 45;
    orientation.read("axis", axis);
    if (!(axis.norm() >= Real(1e-6))) {
      orientation.refuse("axis", "a direction of length 1e-6 or more", "[0, 0, 1]");
    }
    orientation.need("degrees", degrees);
    q = about(axis, degrees);
  } else if (orientation.has("euler_degrees")) {
    Vec3 angles = Vec3::Zero();
    orientation.read("euler_degrees", angles);
    q = about(Vec3::UnitZ(), angles.z()) * about(Vec3::UnitY(), angles.y()) *
        about(Vec3::UnitX(), angles.x());
  } else {
    throw SceneFault(orientation.path(),
                     "expected \"quaternion\", \"axis\" or \"euler_degrees\"; for example " +
                         std::string(orientation_example));
  }
  orientation.refuse_other_keys();
  return q.normalized();
}

CollisionFilter read_filter(SceneReader filter) {
  CollisionFilter result;
  filter.read("category", result.category);
  filter.read("mask", result.mask);
  filter.refuse_other_keys();
  return result;
}

}  // namespace

NamedBody read_body_without_shape(SceneReader& body) {
  NamedBody result;
  BodyDef& def = result.def;
  body.read("name", result.name);
  if (result.name.size() > longest_name) {
    body.refuse("name", "a text of at most " + std::to_string(longest_name) + " bytes",
                R"("lower brick")");
  }
  body.read("kind", def.kind,
            Names<BodyKind>{{"dynamic", BodyKind::Dynamic},
                            {"static", BodyKind::Static},
                            {"kinematic", BodyKind::Kinematic}});
  if (body.has("mass")) {
    Real mass = 1;
    body.read("mass", mass, 1e-9, 1e12);
    def.mass = mass;
    if (body.has("density")) {
      throw SceneFault(body.path(),
                       "expected \"mass\" or \"density\", found both; remove one of the two");
    }
  }
  body.read("density", def.density, Range::Positive);

  body.read("position", def.pose.position);
  if (body.has("orientation")) {
    def.pose.orientation =
        read_orientation(body.object("orientation", R"({"axis": [0, 0, 1], "degrees": 30})"));
  }
  body.read("linear_velocity", def.linear_velocity);
  body.read("angular_velocity", def.angular_velocity);

  body.read("friction", def.friction, Range::NotNegative);
  body.read("restitution", def.restitution, Range::ZeroToOne);
  if (body.has("filter")) {
    def.filter = read_filter(body.object("filter", R"({"category": 1, "mask": 1})"));
  }
  return result;
}

NamedBody read_body(SceneReader body, const SceneShapes& shapes) {
  NamedBody result = read_body_without_shape(body);
  result.def.shape = shapes.read(body, "shape");
  body.refuse_other_keys();
  return result;
}

}  // namespace cs550
