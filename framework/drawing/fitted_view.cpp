#include "drawing/fitted_view.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cs550::drawing {
namespace {

/// The axes of the page in world coordinates.
struct PageAxes {
  Vec3 right, up, toward_eye;
};

PageAxes page_axes(const View& view) {
  const bool usable = view.toward_eye.allFinite() && view.toward_eye.norm() > 0;
  const Vec3 toward_eye = (usable ? view.toward_eye : View{}.toward_eye).normalized();
  Vec3 right = view.up.cross(toward_eye);
  // If the view is along `up`, any direction can be to the right.
  if (!right.allFinite() || right.norm() < Real(1e-4) * view.up.norm() || right.norm() == 0) {
    right = any_perpendicular(toward_eye);
  }
  right.normalize();
  return {right, toward_eye.cross(right), toward_eye};
}

std::vector<Vec3> corners(const Bounds& box) {
  std::vector<Vec3> result;
  result.reserve(8);
  for (int i = 0; i < 8; ++i) {
    result.emplace_back((i & 1) == 0 ? box.lower.x() : box.upper.x(),
                        (i & 2) == 0 ? box.lower.y() : box.upper.y(),
                        (i & 4) == 0 ? box.lower.z() : box.upper.z());
  }
  return result;
}

/// The four ends of the outline of the largest ball in a cube.
std::vector<Vec3> ball_outline(const Bounds& cube, const PageAxes& axes) {
  const Real radius = Real(0.5) * cube.extent().minCoeff();
  const Vec3 center = cube.center();
  return {center - radius * axes.right, center + radius * axes.right, center - radius * axes.up,
          center + radius * axes.up};
}

bool is_empty(const Bounds& box) { return !(box.lower.array() <= box.upper.array()).all(); }

}  // namespace

FittedView::FittedView(const View& view, std::span<const Vec3> keep_in_view,
                       const Rectangle& page) {
  const PageAxes axes = page_axes(view);
  right_ = axes.right;
  up_ = axes.up;
  toward_eye_ = axes.toward_eye;

  std::vector<Vec3> positions;
  if (!is_empty(view.frame)) {
    positions = view.frames_ball ? ball_outline(view.frame, axes) : corners(view.frame);
  } else {
    std::copy_if(keep_in_view.begin(), keep_in_view.end(), std::back_inserter(positions),
                 is_finite);
  }
  if (positions.empty()) positions = {-Vec3::Ones(), Vec3::Ones()};

  Bounds box;
  for (const Vec3& position : positions) box.include(position);
  target_ = box.center();
  radius_ = std::max(0.5 * static_cast<double>(box.extent().norm()), 1e-9);
  if (view.field_of_view > 0) {
    eye_distance_ = radius_ / std::sin(0.5 * static_cast<double>(view.field_of_view));
  }

  double low[2] = {HUGE_VAL, HUGE_VAL};
  double high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const Vec3& position : positions) {
    const Eigen::Vector3d image = image_point(position);
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], image[i]);
      high[i] = std::max(high[i], image[i]);
    }
  }
  // A thin object must not be enlarged to the height of the page.
  const double least = 1e-6 * radius_;
  scale_ = std::min(page.width / std::max(high[0] - low[0], least),
                    page.height / std::max(high[1] - low[1], least));
  x_offset_ = page.left + 0.5 * page.width - scale_ * 0.5 * (low[0] + high[0]);
  y_offset_ = page.top + 0.5 * page.height + scale_ * 0.5 * (low[1] + high[1]);
}

Eigen::Vector3d FittedView::image_point(const Vec3& position) const {
  const Eigen::Vector3d offset = (position - target_).cast<double>();
  const double x = right_.cast<double>().dot(offset);
  const double y = up_.cast<double>().dot(offset);
  const double z = toward_eye_.cast<double>().dot(offset);
  if (eye_distance_ == 0) return {x, y, z};
  // A point behind the eye is projected as if just in front of it, which is outside the page.
  const double distance = std::max(eye_distance_ - z, 0.02 * eye_distance_);
  const double shrink = eye_distance_ / distance;
  return {shrink * x, shrink * y, shrink * eye_distance_};
}

Projected FittedView::project(const Vec3& position) const {
  const Eigen::Vector3d image = image_point(position);
  return {x_offset_ + scale_ * image.x(), y_offset_ - scale_ * image.y(), image.z()};
}

double FittedView::pixels(const Vec3& at, double length) const {
  if (eye_distance_ == 0) return scale_ * length;
  return scale_ * length * image_point(at).z() / eye_distance_;
}

std::vector<Vec3> outline_positions(const Drawing& drawing, const View& view) {
  std::vector<Vec3> positions;
  for (const Point& point : drawing.points) positions.push_back(point.position);
  for (const Line& line : drawing.lines) {
    positions.push_back(line.from);
    positions.push_back(line.to);
  }
  for (const Polygon& polygon : drawing.polygons) {
    positions.insert(positions.end(), polygon.corners.begin(), polygon.corners.end());
  }
  const PageAxes axes = page_axes(view);
  for (const Ball& ball : drawing.balls) {
    for (const Real sign : {-ball.radius, ball.radius}) {
      positions.emplace_back(ball.center + sign * axes.right);
      positions.emplace_back(ball.center + sign * axes.up);
    }
  }
  for (const Label& label : drawing.labels) positions.push_back(label.position);
  return positions;
}

}  // namespace cs550::drawing
