#include "pages/world/world_page.hpp"

#include <algorithm>
#include <cmath>

#include "pages/base/colours.hpp"
#include "pages/base/cutaway.hpp"
#include "pages/base/units.hpp"
#include "pages/world/simulation.hpp"
#include "pages/world/world_controls.hpp"
#include "pages/world/world_plots.hpp"

namespace cs550::pages {
namespace {

constexpr std::size_t history_length = 900;  ///< number of steps in the plots
constexpr Real throw_speed = 20;             ///< m/s
constexpr Real largest_thrown_side = 5000;   ///< m: a world refuses bodies that are much heavier

/// "1 body", "3 bodies".
std::string counted(std::ptrdiff_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

/// A box with some extent along each axis: far from the origin, float may not resolve that of a body.
Bounds resolved(Bounds box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] != box.upper[axis]) continue;
    box.lower[axis] = std::nextafter(box.lower[axis], -HUGE_VALF);
    box.upper[axis] = std::nextafter(box.upper[axis], HUGE_VALF);
  }
  return box;
}

}  // namespace

WorldPage::WorldPage(std::string scene, Isolation isolation)
    : scene_(std::move(scene)), isolation_(isolation) {}

std::string WorldPage::title() const { return info_.title.empty() ? scene_ : info_.title; }

std::string WorldPage::story() const { return info_.description; }

void WorldPage::describe(ControlVisitor& visit) {
  pages::describe(overlays_, visit);
  pages::describe(settings_, visit);
}

void WorldPage::load(const std::string& scene) {
  scene_ = scene;
  is_loaded_ = false;
  info_ = {};
  settings_ = {};
  reset();
}

void WorldPage::reset() {
  service_ = std::make_unique<isolation::Service<WorldRequest, WorldFrame>>(
      [simulation = std::make_shared<Simulation>()](const WorldRequest& request) {
        return simulation->serve(request);
      },
      isolation_);
  frame_ = {};
  meshes_.clear();
  history_.clear();
  failure_.clear();
  selected_.reset();
  let_go();
  WorldRequest request;
  request.scene = scene_;
  if (is_loaded_) request.settings = settings_;
  ask(request);
}

void WorldPage::take_steps(int count) {
  if (!service_) reset();
  WorldRequest request;
  request.pull = pull_;
  request.settings = settings_;
  constexpr int most = 10;  // per answer, for which a student's code has a limited time
  for (; count > 0 && failure_.empty(); count -= most) {
    request.steps = std::min(count, most);
    ask(request);
  }
}

void WorldPage::throw_box(const Vec3& from, const Vec3& direction) {
  WorldRequest request;
  request.settings = settings_;
  const Real side = std::min(Real(0.12) * first_focus_.radius, largest_thrown_side);
  request.thrown = Throw{from, throw_speed * direction.normalized(), side};
  ask(request);
}

void WorldPage::ask(const WorldRequest& request) {
  if (!failure_.empty()) return;
  const isolation::Answer<WorldFrame> answer = service_->ask(request);
  failure_ = answer.failure;
  if (failure_.empty()) receive(answer.value);
}

void WorldPage::receive(const WorldFrame& frame) {
  frame_ = frame;
  for (const HalfEdgeMesh& mesh : frame.meshes) {
    meshes_.push_back(std::make_shared<const HalfEdgeMesh>(mesh));
  }
  history_.insert(history_.end(), frame.samples.begin(), frame.samples.end());
  while (history_.size() > history_length) history_.pop_front();
  if (frame.scene) {
    info_ = *frame.scene;
    if (!is_loaded_) settings_ = info_.settings;
    is_loaded_ = true;
  }
  find_focus();
}

/// Bodies fall, and should still be in view when they land: a box that is above an immovable body is extended down to
/// its top.
Bounds WorldPage::down_to_the_ground(Bounds box) const {
  Real ground = -HUGE_VALF;
  for (std::size_t i = 0; i < frame_.bodies.size(); ++i) {
    const Bounds& other = frame_.bounds[i];
    const bool is_below = other.upper.z() < box.center().z() &&
                          (other.lower.head<2>().array() < box.upper.head<2>().array()).all() &&
                          (other.upper.head<2>().array() > box.lower.head<2>().array()).all();
    if (is_below && frame_.bodies[i].kind != BodyKind::Dynamic)
      ground = std::max(ground, other.upper.z());
  }
  if (std::isfinite(ground)) box.lower.z() = std::min(box.lower.z(), ground);
  return box;
}

/// The movable bodies, except a few that are far from the rest and those that left the scene. All bodies if none is
/// movable.
void WorldPage::find_focus() {
  Bounds all;
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < frame_.bodies.size(); ++i) {
    all.include(frame_.bounds[i]);
    if (frame_.bodies[i].kind == BodyKind::Dynamic) moving.push_back(i);
  }
  const auto is_near = [&](std::size_t i) {
    constexpr Real far = 5;  // radii
    const Vec3 way = frame_.bodies[i].pose.position - first_focus_.center;
    return way.norm() <= far * first_focus_.radius;
  };
  if (!frame_.scene && std::any_of(moving.begin(), moving.end(), is_near)) {
    std::erase_if(moving, [&](std::size_t i) { return !is_near(i); });
  }
  Bounds core;
  for (int axis = 0; axis < 3; ++axis) {
    const auto before = [&](std::size_t a, std::size_t b) {
      return frame_.bodies[a].pose.position[axis] < frame_.bodies[b].pose.position[axis];
    };
    std::sort(moving.begin(), moving.end(), before);
    const std::size_t few = moving.size() / 25;
    for (std::size_t i = few; i + few < moving.size(); ++i) {
      core.lower[axis] = std::min(core.lower[axis], frame_.bounds[moving[i]].lower[axis]);
      core.upper[axis] = std::max(core.upper[axis], frame_.bounds[moving[i]].upper[axis]);
    }
  }
  const Bounds shown = resolved(moving.empty() ? all : down_to_the_ground(core));
  if ((shown.lower.array() < shown.upper.array()).all()) {
    focus_ = focus_of(shown);
    focus_.radius *= Real(1.06);  // margin
  }
  if (frame_.scene) first_focus_ = focus_;
}

void WorldPage::refresh() {
  if (!service_) reset();
  content_ = {};
  content_.problem = failure_;
  content_.focus = focus_;
  content_.solids = solids();
  content_.drawing = draw_overlays(overlays_, frame_, meshes_, Real(0.06) * focus_.radius);
  if (selected_) {
    const Index body = *selected_;
    const Index mesh = frame_.mesh_of_body[body];
    drawing::append(content_.drawing, draw_selection(*meshes_[mesh], frame_.bodies[body].pose));
  }
  if (is_dragging()) {
    const Pose& pose = frame_.bodies[pull_.body].pose;
    content_.drawing.lines.push_back({pose.to_world(pull_.anchor),
                                      pull_.target,
                                      {drawing::Role::Highlight, Real(2.5), true, false}});
  }
  for (const std::string& problem : frame_.problems) content_.drawing.notes.push_back(problem);
  if (frame_.is_lost) content_.lost = frame_.problems.front();
  content_.plots = world_plots(history_, shows_times_);
  content_.facts = facts();
}

std::vector<Solid> WorldPage::solids() const {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < frame_.bodies.size(); ++i) {
    const Index mesh = frame_.mesh_of_body[i];
    if (mesh == no_index) continue;
    Solid solid;
    solid.mesh = meshes_[mesh];
    solid.pose = frame_.bodies[i].pose;
    solid.is_ground = frame_.bodies[i].kind == BodyKind::Static;
    solid.colour = solid.is_ground ? ground_colour() : body_colour(mesh, static_cast<Index>(i));
    if (frame_.bodies[i].asleep) solid.colour = asleep_colour(solid.colour);
    if (!solid.is_ground && overlays_.are_inside()) solid.colour.w() = 0.4F;
    if (!solid.is_ground && overlays_.wireframe) solid.colour.w() = 0.25F;
    solids.push_back(solid);
  }
  return solids;
}

std::vector<Fact> WorldPage::facts() const {
  std::vector<Fact> facts;
  facts.push_back({"time", quantity(frame_.time, "s")});
  facts.push_back({"step", std::to_string(frame_.step)});
  const auto asleep = std::count_if(frame_.bodies.begin(), frame_.bodies.end(),
                                    [](const RigidBody& body) { return body.asleep; });
  if (!history_.empty()) {
    const StepSample& now = history_.back();
    // A step counts the contacts that it solves. Those of sleepers are drawn, but not counted.
    facts.push_back({asleep > 0 ? "awake contacts" : "contacts",
                     std::to_string(now.contacts) + ", " + counted(now.points, "point", "points")});
    facts.push_back({"kinetic energy", quantity(now.kinetic, "J")});
    facts.push_back({"penetration", quantity(static_cast<double>(now.penetration), "m")});
  }
  if (asleep > 0) facts.push_back({"asleep", counted(asleep, "body", "bodies")});
  if (!selected_) return facts;
  const auto place = static_cast<std::size_t>(*selected_);
  const RigidBody& body = frame_.bodies[place];
  const std::string& name = place < info_.body_names.size() ? info_.body_names[place] : "";
  facts.push_back({"", ""});
  facts.push_back({"body " + std::to_string(*selected_), name});
  if (body.kind == BodyKind::Dynamic) {
    facts.push_back({"mass", quantity(static_cast<double>(body.mass), "kg")});
  }
  if (body.asleep) facts.push_back({"asleep", "until something disturbs it"});
  facts.push_back({"x", quantity(body.pose.position, "m")});
  facts.push_back({"v", quantity(body.linear_velocity, "m/s")});
  facts.push_back({"ω", quantity(body.angular_velocity, "rad/s")});
  facts.push_back({"P", quantity(body.linear_momentum, "kg·m/s")});
  facts.push_back({"L", quantity(body.angular_momentum, "kg·m²/s")});
  facts.push_back({"energy", quantity(static_cast<double>(kinetic_energy(body)), "J")});
  return facts;
}

std::optional<WorldPage::Hit> WorldPage::pick(const Vec3& origin, const Vec3& direction) const {
  std::vector<Solid> seen = solids();
  open_view(seen, origin);
  auto solid = seen.begin();
  Hit hit;
  Real nearest = HUGE_VALF;
  for (std::size_t i = 0; i < frame_.bodies.size(); ++i) {
    if (frame_.mesh_of_body[i] == no_index) continue;
    const auto& [mesh, pose, colour, is_ground] = *solid++;
    if (is_ground && colour.w() < 1) continue;
    const Real distance = entry_distance(*mesh, pose.to_body(origin), pose.unrotate(direction));
    if (distance < nearest) {
      nearest = distance;
      hit = {static_cast<Index>(i), origin + distance * direction};
    }
  }
  if (hit.body == no_index) return {};
  return hit;
}

void WorldPage::select(std::optional<Index> body) { selected_ = body; }

void WorldPage::grab(const Hit& hit) {
  const Pose& pose = frame_.bodies[hit.body].pose;
  pull_ = {hit.body, pose.to_body(hit.point), hit.point};
}

}  // namespace cs550::pages
