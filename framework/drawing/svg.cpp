#include "drawing/svg.hpp"

#include <algorithm>

#include "drawing/svg_parts.hpp"

namespace cs550::drawing {
namespace {

constexpr double page_margin = 16;
constexpr double panel_gap = 18;
constexpr double title_size = 17;
constexpr double panel_title_size = 14;
constexpr double legend_swatch = 26;

/// A panel whose texts are broken into lines.
struct Layout {
  std::vector<std::string> title;
  std::vector<LegendEntry> legend;
  std::vector<std::string> notes;
};

const std::string& title_of(const Panel& panel) {
  const auto* scene = std::get_if<Scene>(&panel);
  return scene != nullptr ? scene->drawing.title : std::get<Plot>(panel).title;
}

const std::string& alt_text_of(const Panel& panel) {
  const auto* scene = std::get_if<Scene>(&panel);
  return scene != nullptr ? scene->drawing.alt_text : std::get<Plot>(panel).alt_text;
}

void add_wrapped(std::vector<std::string>& lines, const std::vector<std::string>& sentences,
                 double width) {
  for (const std::string& sentence : sentences) {
    for (std::string& line : wrap(sentence, small_text, width)) lines.push_back(std::move(line));
  }
}

Layout layout_of(const Panel& panel, double width) {
  Layout layout;
  layout.title = wrap(title_of(panel), panel_title_size, width);
  if (const auto* scene = std::get_if<Scene>(&panel)) {
    layout.legend = scene->drawing.legend;
    add_wrapped(layout.notes, scene->drawing.notes, width);
  } else {
    layout.legend = legend_of(std::get<Plot>(panel));
    add_wrapped(layout.notes, notes_of(std::get<Plot>(panel)), width);
  }
  return layout;
}

/// The number of lines of a legend with several entries per line.
struct LegendPlace {
  double left;
  int line;
};
std::vector<LegendPlace> place_legend(const std::vector<LegendEntry>& legend, double width) {
  std::vector<LegendPlace> places;
  double left = 0;
  int line = 0;
  for (const LegendEntry& entry : legend) {
    const double needed = legend_swatch + 6 + text_width(entry.text, small_text);
    if (left > 0 && left + needed > width) {
      left = 0;
      ++line;
    }
    places.push_back({left, line});
    left += needed + 18;
  }
  return places;
}

int legend_lines(const Layout& layout, double width) {
  return layout.legend.empty() ? 0 : place_legend(layout.legend, width).back().line + 1;
}

void draw_legend_entry(SvgWriter& svg, const LegendEntry& entry, PagePoint at) {
  const Colour ink = colour(entry.stroke.role);
  const double middle = at.y - 0.33 * small_text;
  const double width = static_cast<double>(entry.stroke.width);
  const PagePoint from = {at.x, middle};
  const PagePoint to = {at.x + legend_swatch - 2, middle};
  const bool outlined = needs_outline(entry.stroke.role);
  switch (entry.mark) {
    case LegendMark::Patch:
      svg.rectangle({at.x + 4, middle - 6, 18, 12}, mix(ink, paper, 0.35), ink);
      break;
    case LegendMark::Dot:
      svg.circle({at.x + 0.5 * legend_swatch, middle}, 4.5, ink,
                 outlined ? colour(Role::Text) : paper, 1.2);
      break;
    case LegendMark::Line:
      if (outlined) svg.line(from, to, colour(Role::Text), width + 1.6, entry.stroke.dashed);
      svg.line(from, to, ink, width, entry.stroke.dashed);
      break;
  }
  TextStyle style;
  style.size = small_text;
  svg.text({at.x + legend_swatch + 6, at.y}, entry.text, style);
}

/// The positions that each scene must show: its own, or those of the first scene.
std::vector<Vec3> positions_in_view(const Page& page, const Scene& scene) {
  const auto is_scene = [](const Panel& panel) { return std::holds_alternative<Scene>(panel); };
  const auto first = std::find_if(page.panels.begin(), page.panels.end(), is_scene);
  const Scene& framed = page.framed_by_first ? std::get<Scene>(*first) : scene;
  return outline_positions(framed.drawing, framed.view);
}

/// The page without elements that are not finite.
Page finite_part(Page page) {
  for (Panel& panel : page.panels) {
    if (auto* scene = std::get_if<Scene>(&panel)) scene->drawing = finite_part(scene->drawing);
  }
  return page;
}

/// The title in a browser's tab: that of the page or, without one, that of its first panel.
const std::string& document_title(const Page& page) {
  return page.title.empty() && !page.panels.empty() ? title_of(page.panels.front()) : page.title;
}

std::string full_alt_text(const Page& page) {
  std::string text = page.alt_text;
  for (const Panel& panel : page.panels) {
    const std::string& more = alt_text_of(panel);
    if (!text.empty() && !more.empty()) text += ' ';
    text += more;
  }
  return text;
}

/// Draws panels from left to right. Titles, pictures, legends and notes are aligned in rows.
class PageWriter {
 public:
  explicit PageWriter(const Page& page) : page_(page) {
    const auto count = static_cast<double>(std::max<std::size_t>(page.panels.size(), 1));
    width_ = 2 * page_margin + count * page.panel_size.width + (count - 1) * panel_gap;
    title_ = wrap(page.title, title_size, width_ - 2 * page_margin);
    add_wrapped(notes_, page.notes, width_ - 2 * page_margin);
    for (const Panel& panel : page.panels) {
      layouts_.push_back(layout_of(panel, page.panel_size.width));
      const Layout& layout = layouts_.back();
      title_lines_ = std::max(title_lines_, layout.title.size());
      legend_lines_ = std::max(legend_lines_, legend_lines(layout, page.panel_size.width));
      note_lines_ = std::max(note_lines_, layout.notes.size());
    }
  }

  std::string write() {
    double top = page_margin;
    top = write_lines(title_, page_margin, top, title_size, true);
    if (!title_.empty()) top += 6;
    double bottom = top;
    for (std::size_t i = 0; i < page_.panels.size(); ++i) {
      const double left =
          page_margin + static_cast<double>(i) * (page_.panel_size.width + panel_gap);
      bottom = write_panel(page_.panels[i], layouts_[i], left, top);
    }
    bottom = write_lines(notes_, page_margin, bottom, small_text, false);
    return svg_.document(width_, bottom + 0.6 * page_margin, document_title(page_),
                         full_alt_text(page_));
  }

 private:
  double write_lines(const std::vector<std::string>& lines, double left, double top, double size,
                     bool bold) {
    TextStyle style;
    style.size = size;
    style.bold = bold;
    for (const std::string& line : lines) {
      svg_.text({left, top + size}, line, style);
      top += 1.4 * size;
    }
    return top;
  }

  double write_panel(const Panel& panel, const Layout& layout, double left, double top) {
    svg_.begin_group(alt_text_of(panel));
    write_lines(layout.title, left, top, panel_title_size, true);
    top += static_cast<double>(title_lines_) * 1.4 * panel_title_size + 4;
    const Rectangle area = {left, top, page_.panel_size.width, page_.panel_size.height};
    if (const auto* scene = std::get_if<Scene>(&panel)) {
      draw_scene(svg_, scene->drawing, scene->view, positions_in_view(page_, *scene), area);
    } else {
      draw_plot(svg_, std::get<Plot>(panel), area);
    }
    top += area.height + 4;
    const std::vector<LegendPlace> places = place_legend(layout.legend, area.width);
    for (std::size_t i = 0; i < places.size(); ++i) {
      draw_legend_entry(svg_, layout.legend[i],
                        {left + places[i].left, top + line_height * (places[i].line + 0.8)});
    }
    top += line_height * legend_lines_ + 4;
    write_lines(layout.notes, left, top, small_text, false);
    svg_.end_group();
    return top + static_cast<double>(note_lines_) * 1.4 * small_text;
  }

  const Page& page_;
  SvgWriter svg_;
  double width_ = 0;
  std::vector<std::string> title_, notes_;
  std::vector<Layout> layouts_;
  std::size_t title_lines_ = 0;
  int legend_lines_ = 0;
  std::size_t note_lines_ = 0;
};

}  // namespace

std::string write_svg(const Page& page) {
  const Page drawable = finite_part(page);
  return PageWriter(drawable).write();
}

std::string write_svg(const Drawing& drawing, const View& view, const Size& size) {
  Page page;
  page.panels = {Scene{drawing, view}};
  page.panel_size = size;
  return write_svg(page);
}

std::string write_svg(const Plot& plot, const Size& size) {
  Page page;
  page.panels = {plot};
  page.panel_size = size;
  return write_svg(page);
}

}  // namespace cs550::drawing
