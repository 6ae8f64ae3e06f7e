#include "drawing/painting_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cs550::drawing {
namespace {

using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Outline = std::vector<Vec2d>;
using Kind = BrushStroke::Kind;

/// Smaller overlaps are rounding errors of neighbours that share an edge (pixels², pixels).
constexpr double least_area = 0.25;
constexpr double least_length = 0.05;
/// Outlines of balls.
constexpr int ball_corners = 32;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  }
  return 0.5 * twice;
}

/// A convex region of the page with a depth at every point. It hides what is behind it.
struct Occluder {
  Kind kind = Kind::Polygon;
  std::size_t index = 0;
  Outline outline;              // positive area
  Vec2d low, high;              // its bounds on the page
  Vec3d plane = Vec3d::Zero();  // depth = plane · (x, y, 1)
  double middle_depth = 0;

  double depth(const Vec2d& at) const {
    return plane.x() * at.x() + plane.y() * at.y() + plane.z();
  }
};

void finish_outline(Occluder& occluder) {
  if (signed_area(occluder.outline) < 0) {
    std::reverse(occluder.outline.begin(), occluder.outline.end());
  }
  occluder.low = occluder.high = occluder.outline.front();
  for (const Vec2d& corner : occluder.outline) {
    occluder.low = occluder.low.cwiseMin(corner);
    occluder.high = occluder.high.cwiseMax(corner);
  }
}

Occluder occluder_of(const Polygon& polygon, std::size_t index, const FittedView& view) {
  Occluder result;
  result.index = index;
  Vec3d middle = Vec3d::Zero();
  std::vector<Vec3d> corners;
  for (const Vec3& corner : polygon.corners) {
    const Projected at = view.project(corner);
    corners.emplace_back(at.x, at.y, at.depth);
    result.outline.emplace_back(at.x, at.y);
    middle += corners.back();
  }
  middle /= static_cast<double>(corners.size());
  result.middle_depth = middle.z();
  // Newell's normal in (x, y, depth).
  Vec3d normal = Vec3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normal += (corners[i] - middle).cross(corners[(i + 1) % corners.size()] - middle);
  }
  result.plane = {0, 0, middle.z()};
  if (std::abs(normal.z()) > least_area) {
    result.plane.x() = -normal.x() / normal.z();
    result.plane.y() = -normal.y() / normal.z();
    result.plane.z() -= result.plane.x() * middle.x() + result.plane.y() * middle.y();
  }
  finish_outline(result);
  return result;
}

Occluder occluder_of(const Ball& ball, std::size_t index, const FittedView& view) {
  const Projected center = view.project(ball.center);
  const double radius = view.pixels(ball.center, static_cast<double>(ball.radius));
  Occluder result;
  result.kind = Kind::Ball;
  result.index = index;
  result.plane = {0, 0, center.depth};
  result.middle_depth = center.depth;
  for (int i = 0; i < ball_corners; ++i) {
    const double angle = 2 * static_cast<double>(pi) * i / ball_corners;
    result.outline.emplace_back(center.x + radius * std::cos(angle),
                                center.y + radius * std::sin(angle));
  }
  finish_outline(result);
  return result;
}

/// The part of a convex outline inside another one (Sutherland & Hodgman 1974).
Outline intersection(Outline subject, const Outline& clip) {
  for (std::size_t i = 0; i < clip.size() && !subject.empty(); ++i) {
    const Vec2d& start = clip[i];
    const Vec2d side = clip[(i + 1) % clip.size()] - start;
    Outline kept;
    for (std::size_t k = 0; k < subject.size(); ++k) {
      const Vec2d& p = subject[k];
      const Vec2d& q = subject[(k + 1) % subject.size()];
      const double d_p = cross(side, p - start);
      const double d_q = cross(side, q - start);
      if (d_p >= 0) kept.push_back(p);
      if ((d_p > 0 && d_q < 0) || (d_p < 0 && d_q > 0)) {
        kept.emplace_back(p + d_p / (d_p - d_q) * (q - p));
      }
    }
    subject = kept;
  }
  return subject;
}

/// +1 if `a` is nearer than `b` where they overlap, −1 if it is farther, 0 if they do not overlap.
int nearer(const Occluder& a, const Occluder& b, double tolerance) {
  if ((a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any()) return 0;
  const Outline common = intersection(a.outline, b.outline);
  if (common.size() < 3 || signed_area(common) < least_area) return 0;
  Vec2d middle = Vec2d::Zero();
  for (const Vec2d& corner : common) middle += corner;
  middle /= static_cast<double>(common.size());
  const double difference = a.depth(middle) - b.depth(middle);
  if (std::abs(difference) <= tolerance) return 0;
  return difference > 0 ? 1 : -1;
}

/// Compares the depths of the middles only.
void sort_by_middle(std::vector<Occluder>& occluders) {
  std::sort(occluders.begin(), occluders.end(), [](const Occluder& a, const Occluder& b) {
    return std::pair(a.middle_depth, a.index) < std::pair(b.middle_depth, b.index);
  });
}

/// Back to front: always the farthest that hides no remaining one, or in a cycle the farthest of
/// all.
std::vector<Occluder> back_to_front(std::vector<Occluder> occluders, double tolerance) {
  const std::size_t count = occluders.size();
  if (count > exact_polygons) {
    sort_by_middle(occluders);
    return occluders;
  }
  std::vector<std::vector<std::size_t>> in_front_of(count);
  std::vector<int> behind(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      const int sign = nearer(occluders[i], occluders[k], tolerance);
      if (sign == 0) continue;
      const std::size_t far = sign > 0 ? k : i;
      const std::size_t near = sign > 0 ? i : k;
      in_front_of[far].push_back(near);
      ++behind[near];
    }
  }
  std::vector<Occluder> ordered;
  std::vector<bool> done(count, false);
  while (ordered.size() < count) {
    std::size_t next = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (done[i]) continue;
      const bool better = next == count || (behind[i] <= 0) > (behind[next] <= 0) ||
                          ((behind[i] <= 0) == (behind[next] <= 0) &&
                           occluders[i].middle_depth < occluders[next].middle_depth);
      if (better) next = i;
    }
    done[next] = true;
    for (const std::size_t near : in_front_of[next]) --behind[near];
    ordered.push_back(occluders[next]);
  }
  return ordered;
}

struct Interval {
  double from = 0;
  double to = 1;
  bool holds(double t) const { return from <= t && t <= to; }
};

/// Clips an interval to where an affine function is positive, given its values at 0 and 1.
void keep_positive(Interval& interval, double at_0, double at_1) {
  if (at_0 <= 0 && at_1 <= 0) {
    interval = {1, 0};
  } else if (at_0 < 0) {
    interval.from = std::max(interval.from, at_0 / (at_0 - at_1));
  } else if (at_1 < 0) {
    interval.to = std::min(interval.to, at_0 / (at_0 - at_1));
  }
}

/// The part of a line that an occluder hides (Cyrus & Beck 1978, with depth as one more plane).
Interval hidden_part(const Occluder& occluder, const Vec3d& from, const Vec3d& to,
                     double tolerance) {
  Interval interval;
  const Vec2d p = from.head<2>();
  const Vec2d q = to.head<2>();
  if ((p.cwiseMin(q).array() > occluder.high.array()).any() ||
      (p.cwiseMax(q).array() < occluder.low.array()).any()) {
    return {1, 0};
  }
  for (std::size_t i = 0; i < occluder.outline.size(); ++i) {
    const Vec2d& start = occluder.outline[i];
    const Vec2d side = occluder.outline[(i + 1) % occluder.outline.size()] - start;
    keep_positive(interval, cross(side, p - start), cross(side, q - start));
  }
  keep_positive(interval, occluder.depth(p) - from.z() - tolerance,
                occluder.depth(q) - to.z() - tolerance);
  return interval;
}

Vec3d page_position(const Vec3& position, const FittedView& view) {
  const Projected at = view.project(position);
  return {at.x, at.y, at.depth};
}

/// The strokes painted before each occluder, and at the end those that nothing hides.
using Layers = std::vector<std::vector<BrushStroke>>;

void place_line(Layers& layers, const Line& line, std::size_t index,
                const std::vector<Occluder>& occluders, const FittedView& view) {
  const Vec3d from = page_position(line.from, view);
  const Vec3d to = page_position(line.to, view);
  const double length = (to - from).head<2>().norm();
  std::vector<Interval> hidden;
  std::vector<double> cuts = {0, 1};
  for (const Occluder& occluder : occluders) {
    Interval part = hidden_part(occluder, from, to, view.depth_tolerance());
    if ((part.to - part.from) * length < least_length) part = {1, 0};
    if (part.from < part.to) cuts.insert(cuts.end(), {part.from, part.to});
    hidden.push_back(part);
  }
  std::sort(cuts.begin(), cuts.end());
  if (occluders.size() > exact_polygons) cuts = {0, 1};

  BrushStroke stroke{Kind::Line, index, 0, 0};
  std::size_t layer = layers.size();
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] <= cuts[i - 1]) continue;
    const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
    const auto hides = [middle](const Interval& part) { return part.holds(middle); };
    const auto first = std::find_if(hidden.begin(), hidden.end(), hides);
    const std::size_t here = first - hidden.begin();
    if (here != layer && stroke.to > stroke.from) {
      layers[layer].push_back(stroke);
      stroke.from = cuts[i - 1];
    }
    layer = here;
    stroke.to = cuts[i];
  }
  if (stroke.to > stroke.from) layers[layer].push_back(stroke);
}

void place_point(Layers& layers, const Point& point, std::size_t index,
                 const std::vector<Occluder>& occluders, const FittedView& view) {
  const Vec3d at = page_position(point.position, view);
  const auto hides = [&](const Occluder& occluder) {
    const Vec2d page = at.head<2>();
    for (std::size_t i = 0; i < occluder.outline.size(); ++i) {
      const Vec2d& start = occluder.outline[i];
      const Vec2d side = occluder.outline[(i + 1) % occluder.outline.size()] - start;
      // The polygon's own corners do not count as inside.
      if (cross(side, page - start) < least_length * side.norm()) return false;
    }
    return occluder.depth(page) - at.z() > view.depth_tolerance();
  };
  const auto first = std::find_if(occluders.begin(), occluders.end(), hides);
  layers[first - occluders.begin()].push_back({Kind::Point, index, 0, 1});
}

}  // namespace

std::vector<BrushStroke> painting_order(const Drawing& drawing, const FittedView& view) {
  std::vector<Occluder> occluders;
  for (std::size_t i = 0; i < drawing.polygons.size(); ++i) {
    if (drawing.polygons[i].corners.size() < 3) continue;
    occluders.push_back(occluder_of(drawing.polygons[i], i, view));
  }
  for (std::size_t i = 0; i < drawing.balls.size(); ++i) {
    occluders.push_back(occluder_of(drawing.balls[i], i, view));
  }
  occluders = back_to_front(std::move(occluders), view.depth_tolerance());

  Layers layers(occluders.size() + 1);
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    place_line(layers, drawing.lines[i], i, occluders, view);
  }
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    place_point(layers, drawing.points[i], i, occluders, view);
  }

  std::vector<BrushStroke> order;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    order.insert(order.end(), layers[i].begin(), layers[i].end());
    if (i < occluders.size()) order.push_back({occluders[i].kind, occluders[i].index, 0, 1});
  }
  return order;
}

}  // namespace cs550::drawing
