// The mouse turns the camera, drags bodies and moves a page's handle.
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
  const Vec3 ray = seen.ray(mouse_position());
  world_->throw_box(camera_.eye(), camera_.eye() + ray);
}

void App::hear_mouse() {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 mouse = mouse_position();
  if (world_ != nullptr) {
    hear_drag_of_body(mouse);
  } else {
    hear_drag_of_handle(mouse);
  }
  if (io.WantCaptureMouse || drag_depth_) return;
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
    world_->drag_to(dragged_to(mouse));
  } else {
    world_->let_go();
    drag_depth_.reset();
  }
}

/// A page may let the user move one point: the tip of an arrow, the middle of a body.
void App::hear_drag_of_handle(const Vec2& mouse) {
  constexpr Real reach = 18;  // pixels
  const std::optional<Vec3> handle = page_->handle();
  if (!handle) return;
  const Projection seen = projection();
  const bool pressed =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::GetIO().WantCaptureMouse;
  if (pressed && seen.is_in_front(*handle) &&
      (seen.pixel(*handle) - mouse).norm() < reach * interface_.scale()) {
    drag_depth_ = (*handle - seen.eye()).dot(seen.forward());
  }
  if (!drag_depth_) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    page_->move_handle(dragged_to(mouse));
  } else {
    drag_depth_.reset();
  }
}

/// The point under the mouse at the depth at which the drag began.
Vec3 App::dragged_to(const Vec2& mouse) const {
  const Projection seen = projection();
  const Vec3 ray = seen.ray(mouse);
  return seen.eye() + *drag_depth_ / ray.dot(seen.forward()) * ray;
}

}  // namespace cs550::viewer
