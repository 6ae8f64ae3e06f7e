#include <algorithm>
#include <cmath>

#include "drawing/painting_order.hpp"
#include "drawing/svg_parts.hpp"

namespace cs550::drawing {
namespace {

constexpr double outline_width = 1.6;
constexpr double arrow_length = 4.5;  // line widths, plus arrow_base
constexpr double arrow_base = 4;      // pixels

PagePoint on_page(const Projected& at) { return {at.x, at.y}; }

PagePoint between(PagePoint a, PagePoint b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

double distance(PagePoint a, PagePoint b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Faces that point up and to the left are lighter.
Colour lit(Colour base, const std::vector<Vec3>& corners, const FittedView& view) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  }
  if (normal.norm() == 0) return base;
  normal.normalize();
  if (normal.dot(view.toward_eye()) < 0) normal = -normal;
  const Vec3 light =
      (Real(0.9) * view.up() - Real(0.45) * view.right() + Real(0.7) * view.toward_eye())
          .normalized();
  const double brightness = std::max(0.0, static_cast<double>(normal.dot(light)));
  return mix(base, paper, 0.28 + 0.5 * brightness);
}

/// Letters need more contrast than lines.
Colour label_colour(Role role) {
  return needs_outline(role) ? colour(Role::Text) : mix(colour(role), colour(Role::Text), 0.35);
}

/// The length of the part of a segment inside a box (pixels; Liang & Barsky 1984).
double length_inside(PagePoint a, PagePoint b, const Rectangle& box) {
  double enter = 0, leave = 1;
  const auto clip = [&](double from, double to, double low, double high) {
    if (from == to) {
      if (from < low || from > high) leave = -1;
      return;
    }
    const auto [first, last] =
        std::minmax({(low - from) / (to - from), (high - from) / (to - from)});
    enter = std::max(enter, first);
    leave = std::min(leave, last);
  };
  clip(a.x, b.x, box.left, box.left + box.width);
  clip(a.y, b.y, box.top, box.top + box.height);
  return std::max(0.0, leave - enter) * distance(a, b);
}

/// Places labels one after another, each where it covers the least of lines and of other labels.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rectangle& area) : area_(area) {}

  /// Obstacles that a label should not cover.
  /// @{
  void avoid(const Rectangle& box) { taken_.push_back(box); }
  void avoid(PagePoint from, PagePoint to) { lines_.emplace_back(from, to); }
  /// @}

  /// The best box around a point.
  /// @param outward direction of the preferred side, any length
  Rectangle place(PagePoint at, PagePoint outward, double width, double height) {
    constexpr double gap = 7;
    const double preferred = std::atan2(outward.y, outward.x);
    Rectangle best;
    double least_cost = HUGE_VAL;
    for (int i = 0; i < 16; ++i) {
      const double turn = 2 * static_cast<double>(pi) * i / 16;
      const double x = std::cos(preferred + turn);
      const double y = std::sin(preferred + turn);
      const Rectangle box = {at.x + gap * x + 0.5 * width * (x - 1),
                             at.y + gap * y + 0.5 * height * (y - 1), width, height};
      const double cost = overlap_with_others(box) + 40 * (1 - std::cos(turn));
      if (cost < least_cost) {
        least_cost = cost;
        best = box;
      }
    }
    taken_.push_back(best);
    return best;
  }

 private:
  static double common_area(const Rectangle& a, const Rectangle& b) {
    const double width = std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left);
    const double height = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top);
    return std::max(0.0, width) * std::max(0.0, height);
  }

  double overlap_with_others(const Rectangle& box) const {
    double cost = 20 * (box.width * box.height - common_area(box, area_));
    for (const Rectangle& other : taken_) cost += common_area(box, other);
    for (const auto& [from, to] : lines_) cost += line_cost * length_inside(from, to, box);
    return cost;
  }

  static constexpr double line_cost = 3;  // per pixel of a covered line, in pixels² of overlap

  Rectangle area_;
  std::vector<Rectangle> taken_;
  std::vector<std::pair<PagePoint, PagePoint>> lines_;
};

class ScenePainter {
 public:
  ScenePainter(SvgWriter& svg, const Drawing& drawing, const FittedView& view)
      : svg_(svg), drawing_(drawing), view_(view) {}

  /// Between two faces, lines come first, and all their outlines before the lines themselves. The
  /// outlines of a curve's pieces would otherwise be visible inside it.
  void paint(const std::vector<BrushStroke>& order) {
    for (std::size_t i = 0; i < order.size();) {
      std::size_t end = i;
      while (end < order.size() && order[end].kind == BrushStroke::Kind::Line) ++end;
      for (std::size_t k = i; k < end; ++k) paint_outline(order[k]);
      for (std::size_t k = i; k < end; ++k) paint_line(order[k]);
      if (end < order.size()) paint(order[end++]);
      i = end;
    }
  }

  void paint_labels(const Rectangle& area) {
    // The estimate of text width is slightly too small.
    LabelPlacer placer({area.left + 6, area.top, area.width - 12, area.height});
    for (const Point& point : drawing_.points) {
      const PagePoint at = place(point.position);
      const double r = static_cast<double>(point.radius);
      placer.avoid({at.x - r, at.y - r, 2 * r, 2 * r});
    }
    for (const Line& line : drawing_.lines) placer.avoid(place(line.from), place(line.to));
    const PagePoint middle = {area.left + 0.5 * area.width, area.top + 0.5 * area.height};
    for (const Label& label : drawing_.labels) {
      const PagePoint at = place(label.position);
      const double width = text_width(label.text, small_text);
      const Rectangle box =
          placer.place(at, {at.x - middle.x + 0.01, at.y - middle.y}, width, small_text);
      TextStyle style;
      style.size = small_text;
      style.colour = label_colour(label.role);
      style.anchor = Anchor::Middle;
      style.halo = true;
      svg_.text({box.left + 0.5 * width, box.top + 0.82 * small_text}, label.text, style);
    }
  }

 private:
  void paint(const BrushStroke& stroke) {
    switch (stroke.kind) {
      case BrushStroke::Kind::Polygon:
        return paint(drawing_.polygons[stroke.index]);
      case BrushStroke::Kind::Ball:
        return paint(drawing_.balls[stroke.index]);
      case BrushStroke::Kind::Point:
        return paint(drawing_.points[stroke.index]);
      case BrushStroke::Kind::Line:
        return paint_line(stroke);
    }
  }

  PagePoint place(const Vec3& position) const { return on_page(view_.project(position)); }

  void paint(const Polygon& polygon) {
    std::vector<PagePoint> corners;
    for (const Vec3& corner : polygon.corners) corners.push_back(place(corner));
    svg_.polygon(corners, lit(colour(polygon.role), polygon.corners, view_),
                 static_cast<double>(polygon.opacity));
  }

  void paint(const Ball& ball) {
    svg_.ball(place(ball.center), view_.pixels(ball.center, static_cast<double>(ball.radius)),
              colour(ball.role), static_cast<double>(ball.opacity));
  }

  void paint(const Point& point) {
    svg_.circle(place(point.position), static_cast<double>(point.radius), colour(point.role),
                point.role == Role::Highlight ? colour(Role::Text) : paper, 1.2);
  }

  /// A part of a line on the page.
  struct Part {
    PagePoint start, end;  // of the whole line
    double length;
    double from, to;  // 0–1 along it
    double head;      // length of the arrowhead, 0 for none (pixels)
  };

  Part part_of(const Line& line, double from, double to) const {
    Part part{place(line.from), place(line.to), 0, from, to, 0};
    part.length = distance(part.start, part.end);
    if (line.stroke.arrow && to == 1 && part.length > 0) {
      part.head = std::min(arrow_base + arrow_length * static_cast<double>(line.stroke.width),
                           0.6 * part.length);
      // The line ends inside its arrowhead, so that the tip is sharp.
      part.to = std::max(from, 1 - 0.8 * part.head / part.length);
    }
    return part;
  }

  void paint_outline(const BrushStroke& stroke) {
    const Line& line = drawing_.lines[stroke.index];
    if (needs_outline(line.stroke.role)) {
      paint_part(line, part_of(line, stroke.from, stroke.to), colour(Role::Text), outline_width);
    }
  }

  void paint_line(const BrushStroke& stroke) {
    const Line& line = drawing_.lines[stroke.index];
    paint_part(line, part_of(line, stroke.from, stroke.to), colour(line.stroke.role), 0);
  }

  /// @param wider by how much (pixels)
  void paint_part(const Line& line, const Part& part, Colour ink, double wider) {
    const double width = static_cast<double>(line.stroke.width) + wider;
    svg_.line(between(part.start, part.end, part.from), between(part.start, part.end, part.to), ink,
              width, line.stroke.dashed, part.from * part.length);
    if (part.head == 0) return;
    const double x = (part.end.x - part.start.x) / part.length;
    const double y = (part.end.y - part.start.y) / part.length;
    const double half = 0.36 * part.head + 0.2 * width;
    const PagePoint base = {part.end.x - part.head * x, part.end.y - part.head * y};
    svg_.outlined_polygon(
        {part.end, {base.x - half * y, base.y + half * x}, {base.x + half * y, base.y - half * x}},
        ink, ink, 1 + wider);
  }

  SvgWriter& svg_;
  const Drawing& drawing_;
  const FittedView& view_;
};

}  // namespace

void draw_scene(SvgWriter& svg, const Drawing& drawing, const View& view,
                std::span<const Vec3> keep_in_view, const Rectangle& area) {
  // Room for dots, arrowheads and labels at the border.
  const double margin = std::min(34.0, 0.12 * std::min(area.width, area.height));
  const Rectangle inner = {area.left + margin, area.top + margin, area.width - 2 * margin,
                           area.height - 2 * margin};
  const FittedView fitted(view, keep_in_view, inner);
  svg.begin_clipped(area);
  ScenePainter painter(svg, drawing, fitted);
  painter.paint(painting_order(drawing, fitted));
  painter.paint_labels(area);
  svg.end_group();
  svg.frame(area, mix(colour(Role::Faint), paper, 0.5));
}

}  // namespace cs550::drawing
