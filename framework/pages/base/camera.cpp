#include "pages/base/camera.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace cs550::pages {
namespace {

constexpr Real steepest = Real(1.55);    ///< rad; at π/2 the axes of the view are undefined
constexpr Real near_share = Real(0.02);  ///< of the distance: closer objects are clipped
constexpr Real far_share = 40;           ///< of the distance
constexpr Real degree = pi / 180;

Vec3 direction_from_target(const Camera& camera) {
  return {std::cos(camera.pitch) * std::cos(camera.yaw),
          std::cos(camera.pitch) * std::sin(camera.yaw), std::sin(camera.pitch)};
}

Vec3 sideways(const Vec3& forward) { return forward.cross(Vec3::UnitZ()).normalized(); }

Real focal_length(const Area& area) {
  return Real(0.5) * std::min(area.width, area.height) / std::tan(field_of_view / 2);
}

/// Beyond the largest scene. The products of a projection stay within float.
constexpr Real largest_number = Real(1e7);
constexpr Real nearest = Real(1e-3);  ///< distance of the camera (m)

std::vector<Real> numbers(const std::string& text) {
  std::vector<Real> values;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    std::size_t used = 0;
    Real value = 0;
    try {
      value = std::stof(word, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || used != word.size() || !(std::abs(value) <= largest_number)) {
      throw std::invalid_argument("--camera: '" + word + "' is not a number from -1e7 to 1e7");
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace

Vec3 Camera::eye() const { return target + distance * direction_from_target(*this); }

void Camera::orbit(Real yaw_change, Real pitch_change) {
  yaw += yaw_change;
  pitch = std::clamp(pitch + pitch_change, -steepest, steepest);
}

void Camera::pan(const Vec2& pixels, const Area& area) {
  const Vec3 forward = -direction_from_target(*this);
  const Vec3 right = sideways(forward);
  const Real scale = distance / focal_length(area);
  target += scale * (pixels.y() * right.cross(forward) - pixels.x() * right);
}

void Camera::zoom(Real factor) {
  distance = std::clamp(distance * factor, std::min(nearest, distance),
                        std::max(largest_number, distance));
}

Camera seen_from(Real yaw, Real pitch) {
  Camera camera;
  camera.yaw = yaw;
  camera.pitch = std::clamp(pitch, -steepest, steepest);
  return camera;
}

Camera fitted(Camera camera, const Vec3& center, Real radius) {
  camera.target = center;
  camera.distance = radius / std::sin(field_of_view / 2);
  return camera;
}

Real radius_that_shows(const Camera& camera, const Vec3& center, const Vec3& point) {
  const Vec3 way = point - center;
  const Vec3 backward = direction_from_target(camera);
  const Real nearer = way.dot(backward);
  const Real beside = (way - nearer * backward).norm();
  return std::sin(field_of_view / 2) * (nearer + beside / std::tan(field_of_view / 2));
}

Camera parse_camera(const std::string& text, Camera camera) {
  const std::vector<Real> values = numbers(text);
  if (values.size() != 2 && values.size() != 3 && values.size() != 6) {
    throw std::invalid_argument(
        "write YAW,PITCH or YAW,PITCH,DISTANCE or YAW,PITCH,DISTANCE,X,Y,Z (degrees and metres): "
        "--camera=-60,20,8");
  }
  if (std::abs(values[1]) > steepest / degree) {
    throw std::invalid_argument("the pitch is between -88 and 88 degrees");
  }
  camera.yaw = values[0] * degree;
  camera.pitch = values[1] * degree;
  if (values.size() > 2) {
    if (values[2] < nearest) throw std::invalid_argument("the distance is at least 0.001 m");
    camera.distance = values[2];
  }
  if (values.size() > 3) camera.target = {values[3], values[4], values[5]};
  return camera;
}

Projection::Projection(const Camera& camera, Size canvas, const Area& area)
    : canvas_(canvas),
      eye_(camera.eye()),
      forward_(-direction_from_target(camera)),
      right_(sideways(forward_)),
      up_(right_.cross(forward_)),
      focal_pixels_(focal_length(area)),
      nearest_(near_share * camera.distance),
      center_(area.center()) {
  Matrix4 view = Matrix4::Identity();
  view.block<1, 3>(0, 0) = right_.transpose();
  view.block<1, 3>(1, 0) = up_.transpose();
  view.block<1, 3>(2, 0) = -forward_.transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye_;

  const Real width = static_cast<Real>(canvas.width);
  const Real height = static_cast<Real>(canvas.height);
  const Real near = nearest_;
  const Real far = far_share * camera.distance;
  Matrix4 lens = Matrix4::Zero();
  lens(0, 0) = 2 * focal_pixels_ / width;
  lens(1, 1) = 2 * focal_pixels_ / height;
  // The target is in the middle of the area, not of the canvas.
  lens(0, 2) = 1 - 2 * center_.x() / width;
  lens(1, 2) = 2 * center_.y() / height - 1;
  lens(2, 2) = (near + far) / (near - far);
  lens(2, 3) = 2 * near * far / (near - far);
  lens(3, 2) = -1;
  matrix_ = lens * view;
}

Vec2 Projection::pixel(const Vec3& point) const {
  const Vec3 seen = point - eye_;
  const Real scale = focal_pixels_ / seen.dot(forward_);
  return {center_.x() + scale * seen.dot(right_), center_.y() - scale * seen.dot(up_)};
}

bool Projection::is_in_front(const Vec3& point) const {
  return (point - eye_).dot(forward_) > Real(1e-6);
}

Vec3 Projection::ray(const Vec2& pixel) const {
  return (focal_pixels_ * forward_ + (pixel.x() - center_.x()) * right_ -
          (pixel.y() - center_.y()) * up_)
      .normalized();
}

}  // namespace cs550::pages
