#pragma once
/// @file camera.hpp
/// The camera of a scene.

#include <string>

#include "cs550/math.hpp"
#include "pages/base/area.hpp"

namespace cs550::pages {

/// 4 × 4, column-major, as OpenGL expects.
using Matrix4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;

/// A camera on a sphere around its target; z is up.
struct Camera {
  Vec3 target = Vec3::Zero();  ///< m, in the middle of the picture
  Real distance = 5;           ///< from the target (m)
  Real yaw = Real(-1.05);      ///< about z, from the x axis (rad)
  Real pitch = Real(0.38);     ///< above the horizontal (rad)

  bool operator==(const Camera& other) const {
    return target == other.target && distance == other.distance && yaw == other.yaw &&
           pitch == other.pitch;
  }

  /// The position of the eye (m).
  Vec3 eye() const;
  /// Turns by angles (rad), but not over the poles.
  void orbit(Real yaw_change, Real pitch_change);
  /// Moves parallel to the picture, so that the target follows the mouse. @param pixels right, down
  void pan(const Vec2& pixels, const Area& area);
  /// Multiplies the distance, within the range of parse_camera().
  void zoom(Real factor);
};

/// A camera with a direction, but not from a pole; fitted() determines its position.
/// @param yaw, pitch rad
Camera seen_from(Real yaw, Real pitch);

/// The field of view along the shorter side of a picture (rad).
inline constexpr Real field_of_view = Real(0.56);

/// The camera with its direction, moved so that a ball is completely visible.
Camera fitted(Camera camera, const Vec3& center, Real radius);

/// The smallest radius for which fitted() shows a point (m).
/// @param camera only its direction matters
Real radius_that_shows(const Camera& camera, const Vec3& center, const Vec3& point);

/// Reads YAW,PITCH[,DISTANCE[,X,Y,Z]] (degrees, metres). Omitted values are kept.
/// @throws std::invalid_argument with what is wrong and how to fix it
Camera parse_camera(const std::string& text, Camera camera);

/// The projection from world coordinates to the pixels of an area of a canvas.
class Projection {
 public:
  /// @param area centred at the camera's target; what is outside of it is drawn too
  Projection(const Camera& camera, Size canvas, const Area& area);

  /// From the world to OpenGL's clip coordinates.
  const Matrix4& matrix() const { return matrix_; }
  /// Pixels from the top left. @pre is_in_front(point)
  Vec2 pixel(const Vec3& point) const;
  /// Whether a point is in front of the camera.
  bool is_in_front(const Vec3& point) const;
  /// The direction of the ray through a pixel, unit.
  Vec3 ray(const Vec2& pixel) const;
  /// Distance of the near clipping plane (m).
  Real nearest() const { return nearest_; }
  /// Position (m) and axes of the camera.
  /// @{
  const Vec3& eye() const { return eye_; }
  const Vec3& forward() const { return forward_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  /// @}

 private:
  Size canvas_;
  Vec3 eye_;
  Vec3 forward_;
  Vec3 right_;
  Vec3 up_;
  Real focal_pixels_;
  Real nearest_;
  Vec2 center_;
  Matrix4 matrix_;
};

}  // namespace cs550::pages
