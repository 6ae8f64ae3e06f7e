#pragma once
/// @file camera.hpp
/// From where a scene is seen.

#include <string>

#include "cs550/math.hpp"
#include "pages/base/area.hpp"

namespace cs550::pages {

/// 4 × 4, column-major, as OpenGL takes it.
using Matrix4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;

/// A camera on a sphere about what it looks at; z is up.
struct Camera {
  Vec3 target = Vec3::Zero();  ///< m, in the middle of the picture
  Real distance = 5;           ///< from the target (m)
  Real yaw = Real(-1.05);      ///< about z, from the x axis (rad)
  Real pitch = Real(0.38);     ///< above the horizontal (rad)

  /// Where it is (m).
  Vec3 eye() const;
  /// Turns by angles (rad); stays short of the poles.
  void orbit(Real yaw_change, Real pitch_change);
  /// Moves sideways and up, so that what is at the target follows the mouse. @param pixels down right
  void pan(const Vec2& pixels, const Area& area);
  /// Multiplies the distance.
  void zoom(Real factor);
};

/// A camera that looks from a side; where it is follows from fitted(). @param yaw, pitch rad
Camera seen_from(Real yaw, Real pitch);

/// The angle that the shorter side of a picture spans (rad).
inline constexpr Real field_of_view = Real(0.56);

/// A camera that sees the whole of a ball from its present direction.
Camera fitted(Camera camera, const Vec3& center, Real radius);

/// Reads YAW,PITCH[,DISTANCE[,X,Y,Z]] (degrees, metres); what is left out stays as it is.
/// @throws std::invalid_argument that says what is wrong and how to mend it
Camera parse_camera(const std::string& text, Camera camera);

/// How world coordinates become pixels of an area of a canvas.
class Projection {
 public:
  /// @param area where the camera's target is in the middle; what is outside is drawn, too
  Projection(const Camera& camera, Size canvas, const Area& area);

  /// World to OpenGL's clip coordinates.
  const Matrix4& matrix() const { return matrix_; }
  /// Pixels from the top left. Precondition: is_in_front(point)
  Vec2 pixel(const Vec3& point) const;
  /// Whether a point is before the camera.
  bool is_in_front(const Vec3& point) const;
  /// The direction, unit, in which a pixel is seen.
  Vec3 ray(const Vec2& pixel) const;
  /// What is closer to the eye than this is not seen (m).
  Real nearest() const { return nearest_; }
  /// Where the camera is (m), and its axes.
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
