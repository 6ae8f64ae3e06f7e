// The legends of the labs' pages.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "pages/make_page.hpp"

namespace cs550::test {
namespace {

using drawing::Drawing;
using drawing::LegendEntry;
using drawing::LegendMark;
using drawing::Role;

/// The colours of a drawing that mean something. Grey is context; axes and texts are labelled in space.
std::set<Role> meaningful_roles(const Drawing& drawing) {
  std::set<Role> roles;
  for (const drawing::Point& point : drawing.points) roles.insert(point.role);
  for (const drawing::Line& line : drawing.lines) roles.insert(line.stroke.role);
  for (const drawing::Polygon& polygon : drawing.polygons) roles.insert(polygon.role);
  for (const Role role : {Role::Faint, Role::Axis, Role::Text}) roles.erase(role);
  return roles;
}

void expect_explained(const Drawing& drawing) {
  std::set<Role> explained;
  std::set<std::tuple<Role, LegendMark, bool>> symbols;
  for (const LegendEntry& entry : drawing.legend) {
    explained.insert(entry.stroke.role);
    EXPECT_TRUE(symbols.emplace(entry.stroke.role, entry.mark, entry.stroke.dashed).second)
        << "another entry has the symbol of \"" << entry.text << '"';
  }
  for (const Role role : meaningful_roles(drawing)) {
    EXPECT_TRUE(explained.count(role)) << "role " << static_cast<int>(role);
  }
}

TEST(Legends, ExplainEachColourOnce) {
  for (int lab = 1; lab <= pages::lab_page_count; ++lab) {
    pages::PageChoice choice;
    choice.lab = lab;
    const auto page = pages::make_page(choice);
    page->refresh();
    const int steps = page->content().step_count;
    page->rewind();
    for (int step = 0; step < std::min(steps, 12); ++step) {
      SCOPED_TRACE(testing::Message() << "page " << lab << ", step " << step);
      page->refresh();
      expect_explained(page->content().drawing);
      page->advance();
    }
  }
}

}  // namespace
}  // namespace cs550::test
