#include "drawing/svg_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/markup.hpp"

namespace cs550::drawing {
namespace {

/// Far outside of any page. Some programs fail on numbers like 1e30.
constexpr double farthest = 1e5;

std::string number(double value) {
  std::string result = fmt::format("{:.2f}", std::clamp(value, -farthest, farthest));
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}
std::string attribute(const char* name, double value) { return attribute(name, number(value)); }

std::string coordinates(const std::vector<PagePoint>& points) {
  std::string result;
  for (const PagePoint& point : points) {
    if (!result.empty()) result += ' ';
    result += number(point.x) + ',' + number(point.y);
  }
  return attribute("points", result);
}

std::string stroke(Colour colour, double width, bool dashed) {
  std::string result = attribute("stroke", hex(colour)) + attribute("stroke-width", width);
  if (dashed)
    result += attribute("stroke-dasharray", number(3 * width) + ' ' + number(2.5 * width));
  return result;
}

bool is_continuation_byte(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

double text_width(const std::string& text, double size) {
  const auto letters = text.size() - std::count_if(text.begin(), text.end(), is_continuation_byte);
  return 0.6 * size * static_cast<double>(letters);
}

std::vector<std::string> wrap(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) {
    std::string longer = line;
    if (!longer.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && text_width(longer, size) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

void SvgWriter::line(PagePoint from, PagePoint to, Colour colour, double width, bool dashed,
                     double dash_offset) {
  body_ << "<line" << attribute("x1", from.x) << attribute("y1", from.y) << attribute("x2", to.x)
        << attribute("y2", to.y) << stroke(colour, width, dashed);
  if (dashed && dash_offset != 0) body_ << attribute("stroke-dashoffset", dash_offset);
  if (!dashed) body_ << " stroke-linecap=\"round\"";
  body_ << "/>\n";
}

void SvgWriter::polyline(const std::vector<PagePoint>& points, Colour colour, double width,
                         bool dashed) {
  body_ << "<polyline" << coordinates(points) << stroke(colour, width, dashed)
        << " fill=\"none\" stroke-linejoin=\"round\"/>\n";
}

void SvgWriter::polygon(const std::vector<PagePoint>& points, Colour fill, double opacity) {
  body_ << "<polygon" << coordinates(points) << attribute("fill", hex(fill));
  if (opacity < 1) body_ << attribute("fill-opacity", opacity);
  body_ << "/>\n";
}

void SvgWriter::outlined_polygon(const std::vector<PagePoint>& points, Colour fill, Colour outline,
                                 double outline_width) {
  body_ << "<polygon" << coordinates(points) << attribute("fill", hex(fill))
        << stroke(outline, outline_width, false) << " stroke-linejoin=\"round\"/>\n";
}

void SvgWriter::circle(PagePoint center, double radius, Colour fill, Colour outline,
                       double outline_width) {
  body_ << "<circle" << attribute("cx", center.x) << attribute("cy", center.y)
        << attribute("r", radius) << attribute("fill", hex(fill))
        << stroke(outline, outline_width, false) << "/>\n";
}

void SvgWriter::ball(PagePoint center, double radius, Colour colour, double opacity) {
  const std::string name = "ball" + std::to_string(definition_count_++);
  definitions_ << "<radialGradient" << attribute("id", name)
               << " cx=\"0.38\" cy=\"0.34\" r=\"0.75\"><stop offset=\"0\""
               << attribute("stop-color", hex(mix(colour, paper, 0.9))) << "/><stop offset=\"1\""
               << attribute("stop-color", hex(mix(colour, paper, 0.35))) << "/></radialGradient>\n";
  body_ << "<circle" << attribute("cx", center.x) << attribute("cy", center.y)
        << attribute("r", radius) << attribute("fill", "url(#" + name + ")")
        << attribute("opacity", opacity) << stroke(mix(colour, paper, 0.1), 1, false) << "/>\n";
}

void SvgWriter::rectangle(const Rectangle& area, Colour fill, Colour outline) {
  body_ << "<rect" << attribute("x", area.left) << attribute("y", area.top)
        << attribute("width", area.width) << attribute("height", area.height)
        << attribute("fill", hex(fill)) << stroke(outline, 1, false) << "/>\n";
}

void SvgWriter::frame(const Rectangle& area, Colour outline) {
  body_ << "<rect" << attribute("x", area.left) << attribute("y", area.top)
        << attribute("width", area.width) << attribute("height", area.height)
        << " rx=\"4\" fill=\"none\"" << stroke(outline, 1, false) << "/>\n";
}

void SvgWriter::text(PagePoint at, const std::string& text, const TextStyle& style) {
  constexpr const char* anchors[] = {"start", "middle", "end"};
  body_ << "<text" << attribute("x", at.x) << attribute("y", at.y)
        << attribute("font-size", style.size) << attribute("fill", hex(style.colour));
  if (style.anchor != Anchor::Start) {
    body_ << attribute("text-anchor", anchors[static_cast<int>(style.anchor)]);
  }
  if (style.bold) body_ << " font-weight=\"600\"";
  if (style.halo) {
    body_ << " paint-order=\"stroke\" stroke-linejoin=\"round\""
          << stroke(paper, 0.25 * style.size, false);
  }
  if (style.upward) {
    body_ << attribute("transform", "rotate(-90 " + number(at.x) + ' ' + number(at.y) + ')');
  }
  body_ << '>' << files::escape_markup(text) << "</text>\n";
}

void SvgWriter::begin_clipped(const Rectangle& area) {
  const std::string name = "clip" + std::to_string(definition_count_++);
  definitions_ << "<clipPath" << attribute("id", name) << "><rect" << attribute("x", area.left)
               << attribute("y", area.top) << attribute("width", area.width)
               << attribute("height", area.height) << "/></clipPath>\n";
  body_ << "<g" << attribute("clip-path", "url(#" + name + ")") << ">\n";
}

void SvgWriter::begin_group(const std::string& alt_text) {
  body_ << "<g role=\"img\"" << attribute("aria-label", files::escape_markup(alt_text)) << ">\n";
}

void SvgWriter::end_group() { body_ << "</g>\n"; }

std::string SvgWriter::document(double width, double height, const std::string& title,
                                const std::string& alt_text) const {
  std::ostringstream file;
  file << "<svg xmlns=\"http://www.w3.org/2000/svg\"" << attribute("width", width)
       << attribute("height", height)
       << attribute("viewBox", "0 0 " + number(width) + ' ' + number(height))
       << " role=\"img\" aria-labelledby=\"title description\""
       << " font-family=\"Inter, 'Source Sans 3', 'DejaVu Sans', Helvetica, Arial, sans-serif\">\n"
       << "<title id=\"title\">" << files::escape_markup(title) << "</title>\n"
       << "<desc id=\"description\">" << files::escape_markup(alt_text) << "</desc>\n";
  const std::string definitions = definitions_.str();
  if (!definitions.empty()) file << "<defs>\n" << definitions << "</defs>\n";
  file << "<rect width=\"100%\" height=\"100%\"" << attribute("fill", hex(paper)) << "/>\n"
       << body_.str() << "</svg>\n";
  return file.str();
}

}  // namespace cs550::drawing
