#pragma once
/// @file fitted_view.hpp
/// The projection from space to the page.

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

/// A position on the page. Lines and planes in space are also lines and planes in (x, y, depth),
/// even in perspective.
struct Projected {
  double x = 0;      ///< pixels, to the right
  double y = 0;      ///< pixels, downward
  double depth = 0;  ///< increases towards the eye (m, at the target)
};

/// A view that is fitted to its contents. It computes in double, because small differences of depth
/// decide what is hidden.
class FittedView {
 public:
  /// @param keep_in_view positions that must be inside the page, unless the view has a frame
  FittedView(const View& view, std::span<const Vec3> keep_in_view, const Rectangle& page);

  /// The projection of a point in space.
  Projected project(const Vec3& position) const;
  /// The projection of a length at a point in space (pixels).
  double pixels(const Vec3& at, double length) const;
  /// Smaller differences of depth are rounding errors (m).
  double depth_tolerance() const { return 1e-4 * radius_; }
  /// The axes of the page: unit, world frame.
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

/// The positions of a drawing that must be visible. A ball has four, at the ends of its outline.
std::vector<Vec3> outline_positions(const Drawing& drawing, const View& view);

}  // namespace cs550::drawing
