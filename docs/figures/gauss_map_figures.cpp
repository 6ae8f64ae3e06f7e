#include "drawing/gauss_map_drawing.hpp"

#include "drawing/mesh_drawing.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

Page minkowski() {
  const std::vector<Vec3> a = {at(-1.6, -0.9), at(0.3, -1.1), at(0.8, 0.3), at(-0.7, 1)};
  const std::vector<Vec3> b = {at(-0.35, -0.3), at(1.25, -0.7), at(1.65, 0.7), at(0.15, 1.0)};
  Drawing bodies;
  add_area(bodies, a, Role::BodyA, 0.45);
  add_area(bodies, b, Role::BodyB, 0.45);
  bodies.labels = {{at(-0.8, -0.2), "A", Role::BodyA}, {at(1.1, 0.2), "B", Role::BodyB}};
  bodies.title = "A and B";

  std::vector<Vec3> differences;
  for (const Vec3& p : a) {
    for (const Vec3& q : b) differences.push_back(q - p);
  }
  Drawing difference;
  const std::vector<Vec3> hull = flat_hull(differences);
  add_area(difference, hull, Role::Incident, 0.4);
  for (const Vec3& point : differences) add_dot(difference, point, Role::Faint, "", 2.5);

  Vec3 nearest = hull[0];
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    const Vec3 foot = hull[i] - hull[i].dot(along) * along;
    if (foot.norm() < nearest.norm()) nearest = foot;
  }
  add_line(difference, at(0, 0), nearest, {Role::Got, 2.5f, false, true});
  difference.labels.push_back({Real(0.5) * nearest + at(0.35, 0.3), "depth", Role::Got});
  add_dot(difference, at(0, 0), Role::Text, "origin", 5);
  difference.title = "B − A";
  return page_of({bodies, difference}, drawing::view_from_above(), {320, 300});
}

Page gauss_map() {
  const ShapePtr shape = box({Real(0.9), Real(0.7), Real(0.6)});
  const PosedShape body{shape.get(),
                        {Vec3::Zero(), rotation_exp(Vec3(Real(0.1), Real(0.1), Real(-0.15)))}};
  Drawing solid = drawing::draw_body(body);
  Drawing map = drawing::draw_unit_sphere();
  drawing::append(map, drawing::draw_gauss_map(body, Role::BodyA));
  solid.title = "body";
  map.title = "Gauss map";
  return page_of({solid, map}, {}, {320, 300});
}

Page arcs() {
  const Vec3 a = Vec3(Real(0.5), Real(-0.8), Real(0.75)).normalized();
  const Vec3 b = Vec3(Real(-0.55), Real(-0.85), Real(-0.05)).normalized();
  const Vec3 c = Vec3(Real(-0.5), Real(-0.8), Real(0.75)).normalized();
  const Vec3 d = Vec3(Real(0.6), Real(-0.85), Real(0)).normalized();
  Drawing crossing = drawing::draw_arc_pair(a, b, c, d);
  Drawing opposite = drawing::draw_arc_pair(a, b, -c, -d);
  crossing.title = "they cross";
  opposite.title = "they do not: opposite hemispheres";
  View view;
  view.toward_eye = Vec3(Real(0.9), Real(-1.3), Real(0.7));
  return page_of({crossing, opposite}, view, {330, 320});
}

}  // namespace

std::vector<Figure> gauss_map_figures() {
  return {{"minkowski", minkowski}, {"gauss_map", gauss_map}, {"arcs", arcs}};
}

}  // namespace cs550::book
