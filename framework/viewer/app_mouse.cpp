// The mouse turns the camera, drags bodies, and moves and turns what a page lets the user drag.
#include <imgui/imgui.h>

#include <cmath>

#include "viewer/app.hpp"

namespace cs550::viewer {
namespace {

constexpr Real turn_per_pixel = Real(0.006);  ///< rad

Vec2 mouse_position() {
  const ImVec2 position = ImGui::GetIO().MousePos;
  return {position.x, position.y};
}

}  // namespace

void App::throw_box() {
  if (world_ == nullptr) return;
  const Projection seen = projection();
  world_->throw_box(camera_.eye(), seen.ray(mouse_position()));
}

void App::hear_mouse() {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 mouse = mouse_position();
  if (world_ != nullptr) {
    hear_drag_of_body(mouse);
  } else {
    hear_drag_of_handle(mouse);
  }
  if (io.WantCaptureMouse || drag_depth_ || grip_) return;
  const Vec2 change(io.MouseDelta.x, io.MouseDelta.y);
  const bool shifts = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                      (io.KeyShift && ImGui::IsMouseDown(ImGuiMouseButton_Left));
  const bool turns =
      ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (shifts) {
    camera_.pan(change, picture_area());
  } else if (turns) {
    camera_.orbit(-turn_per_pixel * change.x(), turn_per_pixel * change.y());
  }
  if (io.MouseWheel != 0) camera_.zoom(std::pow(Real(0.9), io.MouseWheel));
}

/// Pressing a body selects it. It then follows the mouse at a constant depth.
void App::hear_drag_of_body(const Vec2& mouse) {
  const Projection seen = projection();
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (pressed && !ImGui::GetIO().WantCaptureMouse && !ImGui::GetIO().KeyShift) {
    const auto hit = world_->pick(seen.eye(), seen.ray(mouse));
    const bool can_move = hit && world_->frame().bodies[hit->body].kind == BodyKind::Dynamic;
    world_->select(can_move ? std::optional(hit->body) : std::nullopt);
    if (can_move) {
      world_->grab(*hit);
      drag_depth_ = (hit->point - seen.eye()).dot(seen.forward());
    }
  }
  if (!drag_depth_) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    world_->drag_to(at_depth(mouse, *drag_depth_));
  } else {
    world_->let_go();
    drag_depth_.reset();
  }
}

/// The handle nearest to the mouse, within its reach.
std::optional<App::Grip> App::grip_at(const Vec2& mouse, ImGuiMouseButton button) const {
  const Projection seen = projection();
  Real reach = 18 * interface_.scale();  // pixels
  std::optional<Grip> grip;
  const std::vector<pages::Handle> handles = page_->handles();
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const pages::Handle& handle = handles[i];
    if (button == ImGuiMouseButton_Right && !handle.turns) continue;
    if (!seen.is_in_front(handle.point)) continue;
    const Real distance = (seen.pixel(handle.point) - mouse).norm();
    if (distance >= reach) continue;
    reach = distance;
    grip = {i, button, (handle.point - seen.eye()).dot(seen.forward())};
  }
  return grip;
}

/// A lab's page may let the user move points, and turn the bodies around them with the right button.
void App::hear_drag_of_handle(const Vec2& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right}) {
    const bool pans = button == ImGuiMouseButton_Left && io.KeyShift;
    const bool pressed = ImGui::IsMouseClicked(button) && !io.WantCaptureMouse && !pans;
    if (pressed && !grip_) grip_ = grip_at(mouse, button);
  }
  if (!grip_) return;
  if (!ImGui::IsMouseDown(grip_->button)) {
    grip_.reset();
  } else if (grip_->button == ImGuiMouseButton_Left) {
    page_->move_handle(grip_->handle, at_depth(mouse, grip_->depth));
  } else {
    const Projection seen = projection();
    page_->turn_handle(grip_->handle, turn_per_pixel * (io.MouseDelta.x * seen.up() +
                                                        io.MouseDelta.y * seen.right()));
  }
}

void App::nudge(Nudged nudged, Real right, Real up) {
  const std::vector<pages::Handle> handles = page_->handles();
  if (handles.empty()) return;
  const std::size_t handle = nudged == Nudged::First ? 0 : handles.size() - 1;
  const Projection seen = projection();
  const Real step = Real(0.04) * page_->content().focus.radius;
  page_->move_handle(handle,
                     handles[handle].point + step * (right * seen.right() + up * seen.up()));
}

/// The point under the mouse at a distance from the eye, along the view.
Vec3 App::at_depth(const Vec2& mouse, Real depth) const {
  const Projection seen = projection();
  const Vec3 ray = seen.ray(mouse);
  return seen.eye() + depth / ray.dot(seen.forward()) * ray;
}

}  // namespace cs550::viewer
