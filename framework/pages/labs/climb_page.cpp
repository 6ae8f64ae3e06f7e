// Lab 3: an uphill walk over the vertices.
#include "cs550/hill_climbing.hpp"
#include "drawing/climb_drawing.hpp"
#include "pages/labs/lab_page.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {
namespace {

using drawing::Role;

struct ClimbSettings {
  int shape = Icosphere;
  Vec3 direction = {Real(0.45), Real(-0.75), Real(0.55)};
  int start = 20;
  int step = last_step;

  bool operator==(const ClimbSettings&) const = default;
};

void describe(ClimbSettings& settings, ControlVisitor& visit) {
  visit.section("Climb");
  visit.choice({"shape", "shape", ""}, settings.shape, shape_names);
  visit.vector({"direction", "direction", ""}, settings.direction, 2);
  visit.whole({"start", "start at vertex", ""}, settings.start, 0, 161);
  visit.step({"step", "shown step", ""}, settings.step, 60);
}

/// The ball around the shape and the arrow in any direction, so that the shape stays in place while the arrow is
/// dragged. A margin leaves room for the texts beside them.
Focus focus_on_shape_and(const drawing::ClimbArrow& arrow) {
  return {arrow.middle, Real(1.05) * (arrow.tip - arrow.middle).norm()};
}

Content show(const ClimbSettings& settings) {
  const ShapePtr shape = recorded_shape(settings.shape);
  const HalfEdgeMesh& mesh = shape->mesh;
  const Index start = std::min<Index>(settings.start, mesh.vertex_count() - 1);
  std::vector<Index> path;
  const Support climbed = hill_climb(mesh, settings.direction, start, &path);
  const Support searched = support_brute_force(mesh.vertices, settings.direction);

  Content content;
  content.step_count = static_cast<int>(path.size());
  const int step = shown_step(settings.step, content.step_count);
  const std::span<const Index> walked(path.data(),
                                      static_cast<std::size_t>(path.empty() ? 0 : step + 1));
  content.drawing =
      without_faces(drawing::draw_climb(mesh, settings.direction, walked), Role::BodyA);
  content.drawing.legend.push_back(
      {"vertices looked at", {Role::Faint, 3}, drawing::LegendMark::Dot});
  content.solids.push_back(light_solid(mesh));
  content.plots.push_back(drawing::plot_climb(mesh, settings.direction, path));
  content.facts = {{"vertices", std::to_string(mesh.vertex_count())},
                   {"steps", std::to_string(content.step_count - 1)},
                   {"climb", "vertex " + std::to_string(climbed.vertex) + ", " +
                                 std::to_string(climbed.visited) + " dot products"},
                   {"brute force", "vertex " + std::to_string(searched.vertex) + ", " +
                                       std::to_string(searched.visited) + " dot products"}};
  content.focus = focus_on_shape_and(drawing::climb_arrow(mesh, settings.direction));
  return content;
}

std::vector<Handle> handles(const ClimbSettings& settings) {
  const ShapePtr shape = recorded_shape(settings.shape);
  return {{"the arrow", drawing::climb_arrow(shape->mesh, settings.direction).tip}};
}

void move_handle(ClimbSettings& settings, std::size_t /*handle*/, const Vec3& point) {
  const ShapePtr shape = recorded_shape(settings.shape);
  const Vec3 way = point - drawing::climb_arrow(shape->mesh, settings.direction).middle;
  if (way.norm() > Real(0.1)) settings.direction = way.normalized();
}

}  // namespace

std::unique_ptr<Page> make_climb_page(Isolation isolation) {
  LabPageParts<ClimbSettings> parts;
  parts.lab = 3;
  parts.story =
      "The support vertex is found by walking uphill from vertex to vertex. Drag the tip of the "
      "arrow: the walk looks at far fewer vertices than brute force.";
  parts.first_view = seen_from(Real(-1.25), Real(0.3));
  parts.describe = describe;
  parts.show = show;
  parts.handles = handles;
  parts.move_handle = move_handle;
  return std::make_unique<LabPage<ClimbSettings>>(parts, isolation);
}

}  // namespace cs550::pages
