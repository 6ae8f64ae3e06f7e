#pragma once
/// @file fitted_view.hpp
/// How positions in space become positions on the page.

#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/view.hpp"

namespace cs550::drawing {

/// A part of the page (pixels; x to the right, y downward).
struct Rectangle {
  double left = 0;    ///< its smallest x
  double top = 0;     ///< its smallest y
  double width = 0;   ///< along x
  double height = 0;  ///< along y
};

/// A position on the page. Straight lines and planes of space stay straight and plane in (x, y,
/// depth), also in perspective.
struct Projected {
  double x = 0;      ///< pixels, to the right
  double y = 0;      ///< pixels, downward
  double depth = 0;  ///< grows toward the eye (m, at the target)
};

/// A view that is fitted to what it must show. Computes in double: what hides what is decided by
/// small differences.
class FittedView {
 public:
  /// @param keep_in_view positions that must lie within the page, unless the view has a frame
  FittedView(const View& view, std::span<const Vec3> keep_in_view, const Rectangle& page);

  /// Where a point of space appears.
  Projected project(const Vec3& position) const;
  /// How long a length at a point of space appears (pixels).
  double pixels(const Vec3& at, double length) const;
  /// Differences of depth below this are none (m).
  double depth_tolerance() const { return 1e-4 * radius_; }
  /// Unit vectors of the page, world frame.
  /// @{
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  const Vec3& toward_eye() const { return toward_eye_; }
  /// @}

 private:
  Eigen::Vector3d image_point(const Vec3& position) const;

  Vec3 right_, up_, toward_eye_;
  Vec3 target_ = Vec3::Zero();
  double radius_ = 1;
  double eye_distance_ = 0;  // 0: parallel projection
  double scale_ = 1;
  double x_offset_ = 0, y_offset_ = 0;
};

/// The positions of a drawing that a view keeps in view, of balls the four ends of their outline.
std::vector<Vec3> outline_positions(const Drawing& drawing, const View& view);

}  // namespace cs550::drawing
