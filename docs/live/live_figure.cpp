#include "live_figure.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "control_json.hpp"
#include "cs550/scene.hpp"
#include "drawing/svg.hpp"
#include "pages/make_page.hpp"

namespace cs550::live {

namespace {

constexpr drawing::Size plot_size = {420, 240};

/// The role of the most similar colour: SVG knows roles only.
drawing::Role role_of(const pages::Rgba& colour) {
  const auto difference = [&](drawing::Role role) {
    return (pages::role_rgba(role).head<3>() - colour.head<3>()).norm();
  };
  return *std::min_element(
      drawing::all_roles.begin(), drawing::all_roles.end(),
      [&](drawing::Role a, drawing::Role b) { return difference(a) < difference(b); });
}

/// Shaded bodies as faces and edges.
void add_solid(drawing::Drawing& drawing, const pages::Solid& solid) {
  const HalfEdgeMesh& mesh = *solid.mesh;
  const drawing::Role role = role_of(solid.colour);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    drawing::Polygon polygon;
    polygon.role = role;
    polygon.opacity = solid.colour.w();
    for (const Index e : face_edges(mesh, f)) {
      polygon.corners.push_back(solid.pose.to_world(mesh.vertex(mesh.origin(e))));
    }
    drawing.polygons.push_back(std::move(polygon));
  }
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    drawing.lines.push_back({solid.pose.to_world(mesh.vertex(mesh.origin(e))),
                             solid.pose.to_world(mesh.vertex(mesh.edge(e).vertex)),
                             {drawing::Role::Faint, 1, false, false}});
  }
}

/// Whether a body is much larger than what the page focuses on, as a floor is.
bool is_much_larger(const pages::Solid& solid, const pages::Focus& focus) {
  const std::vector<Vec3>& vertices = solid.mesh->vertices;
  return std::any_of(vertices.begin(), vertices.end(), [&](const Vec3& vertex) {
    return (solid.pose.to_world(vertex) - focus.center).norm() > 3 * focus.radius;
  });
}

struct Axes {
  Vec3 toward_eye, right, up;
};

Axes axes_of(const pages::Camera& camera) {
  const Vec3 toward_eye(std::cos(camera.pitch) * std::cos(camera.yaw),
                        std::cos(camera.pitch) * std::sin(camera.yaw), std::sin(camera.pitch));
  const Vec3 right(-std::sin(camera.yaw), std::cos(camera.yaw), 0);
  return {toward_eye, right, toward_eye.cross(right)};
}

}  // namespace

LiveFigure::LiveFigure(const std::string& description) {
  std::istringstream words(description);
  pages::PageChoice choice;
  if (!(words >> choice.lab) || choice.lab < 0 || choice.lab > pages::lab_page_count) {
    throw std::invalid_argument("live figure '" + description +
                                "': expected the number of a page, 0 to 7, first");
  }
  std::vector<std::string> assignments;
  for (std::string word; words >> word;) {
    if (choice.lab == 0 && word.starts_with("scene=")) {
      choice.scene = word.substr(word.find('=') + 1);
    } else {
      assignments.push_back(word);
    }
  }
  page_ = pages::make_page(choice);
  page_->refresh();
  camera_ = page_->first_view();
  world_ = dynamic_cast<pages::WorldPage*>(page_.get());
  scene_ = choice.scene;
  if (world_ != nullptr) canvas_ = std::make_unique<WorldCanvas>(*world_, camera_);
  for (const std::string& assignment : assignments) set(assignment);
  page_->refresh();
}

void LiveFigure::set(const std::string& assignment) {
  const std::string_view reason = why_unavailable(assignment.substr(0, assignment.find('=')));
  if (!reason.empty()) throw std::invalid_argument(std::string(reason) + ": use ./cs550 view");
  if (world_ != nullptr && assignment.starts_with("scene=")) {
    choose_scene(assignment.substr(assignment.find('=') + 1));
    return;
  }
  pages::ControlSetter setter(assignment);
  if (canvas_) canvas_->describe(setter);
  page_->describe(setter);
  setter.expect_found();
}

/// A figure never opens other files: the name must be that of a shipped scene.
void LiveFigure::choose_scene(const std::string& name) {
  const std::vector<std::string> names = shipped_scenes();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::invalid_argument("there is no scene '" + name + "'");
  }
  scene_ = name;
  world_->load(name);
  canvas_->frame_again();
}

std::string LiveFigure::describe() {
  ControlJson lister;
  if (world_ != nullptr) {
    const std::vector<std::string> names = shipped_scenes();
    std::vector<const char*> words;
    words.reserve(names.size());
    for (const std::string& name : names) words.push_back(name.c_str());
    int place = static_cast<int>(std::find(names.begin(), names.end(), scene_) - names.begin());
    lister.choice({"scene", "scene", ""}, place, words);
    canvas_->describe(lister);
  }
  page_->describe(lister);
  return lister.text();
}

void LiveFigure::rewind() {
  if (world_ != nullptr) {
    world_->reset();
    canvas_->frame_again();
  }
  page_->rewind();
}

void LiveFigure::move(std::size_t handle, Real right, Real up) {
  const Axes axes = axes_of(camera_);
  const Real radius = page_->content().focus.radius;
  const Vec3 point = page_->handles().at(handle).point;
  page_->move_handle(handle, point + radius * (right * axes.right + up * axes.up));
}

void LiveFigure::turn(std::size_t handle, Real right, Real up) {
  const Axes axes = axes_of(camera_);
  if (!page_->handles().at(handle).turns) return;
  page_->turn_handle(handle, right * axes.up - up * axes.right);
}

std::string LiveFigure::svg(const drawing::Size& size) {
  page_->refresh();
  const pages::Content& content = page_->content();
  drawing::Scene scene{content.drawing, {}};
  for (const pages::Solid& solid : content.solids) {
    // The painter's order is one of whole faces, and a floor would hide what stands on it.
    if (solid.mesh && !is_much_larger(solid, content.focus)) add_solid(scene.drawing, solid);
  }
  if (!content.problem.empty()) scene.drawing.notes = {content.problem};
  scene.view.toward_eye = axes_of(camera_).toward_eye;
  const Vec3 half = Vec3::Constant(content.focus.radius);
  scene.view.frame.include(content.focus.center - half);
  scene.view.frame.include(content.focus.center + half);
  scene.view.frames_ball = true;
  return write_svg(scene.drawing, scene.view, size);
}

std::string LiveFigure::plot_svg(std::size_t plot) {
  const std::vector<drawing::Plot>& plots = page_->content().plots;
  return plot < plots.size() ? write_svg(plots[plot], plot_size) : "";
}

std::string LiveFigure::facts() {
  const pages::Content& content = page_->content();
  nlohmann::json handles = nlohmann::json::array();
  for (const pages::Handle& handle : page_->handles()) {
    handles.push_back({{"name", handle.name}, {"turns", handle.turns}});
  }
  nlohmann::json facts = nlohmann::json::array();
  for (const pages::Fact& fact : content.facts) facts.push_back({fact.name, fact.value});
  const nlohmann::json all = {{"title", page_->title()},
                              {"story", page_->story()},
                              {"walks", world_ != nullptr || content.step_count > 1},
                              {"canvas", world_ != nullptr},
                              {"h", world_ != nullptr ? world_->step_length() : Real(0)},
                              {"steps", content.step_count},
                              {"plots", content.plots.size()},
                              {"handles", handles},
                              {"problem", content.problem},
                              {"facts", facts}};
  return all.dump();
}

}  // namespace cs550::live
