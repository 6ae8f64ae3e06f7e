// What the reader can drag on the pages of labs.
#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "pages/make_page.hpp"

namespace cs550::test {
namespace {

using namespace pages;

constexpr std::size_t a = 0;
constexpr std::size_t b = 1;

std::unique_ptr<Page> page_of(int lab) {
  PageChoice choice;
  choice.lab = lab;
  std::unique_ptr<Page> page = make_page(choice);
  page->refresh();
  return page;
}

/// A number that the page prints.
std::string fact(Page& page, const std::string& name) {
  page.refresh();
  for (const Fact& fact : page.content().facts) {
    if (fact.name == name) return fact.value;
  }
  return "missing";
}

class TwoBodies : public testing::TestWithParam<int> {};

TEST_P(TwoBodies, CanBothBeMovedAndTurned) {
  const std::vector<pages::Handle> handles = page_of(GetParam())->handles();
  ASSERT_EQ(handles.size(), 2U);
  EXPECT_EQ(handles[a].name, "A");
  EXPECT_EQ(handles[b].name, "B");
  EXPECT_TRUE(handles[a].turns && handles[b].turns);
}

TEST_P(TwoBodies, StayWithinTheRangeOfTheirSettings) {
  const std::unique_ptr<Page> page = page_of(GetParam());
  for (const std::size_t body : {a, b}) {
    page->move_handle(body, {100, -100, 1});
    page->turn_handle(body, {Real(0.3), 3, -3});
    EXPECT_EQ(page->handles()[body].point, Vec3(4, -4, 1));
  }
  ControlLister lister;
  page->describe(lister);
  std::istringstream lines(lister.text());
  for (std::string assignment; lines >> assignment; lines.ignore(1000, '\n')) {
    if (assignment.find('=') == std::string::npos) continue;
    ControlSetter setter(assignment);
    EXPECT_NO_THROW(page->describe(setter)) << assignment;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, TwoBodies, testing::Values(4, 5));

TEST(Handles, OnlyTheirRelativePositionMatters) {
  const std::unique_ptr<Page> page = page_of(4);
  const std::string separation = fact(*page, "separation");
  const Vec3 way(Real(0.25), Real(-0.5), Real(0.125));
  page->move_handle(a, page->handles()[a].point + way);
  EXPECT_NE(fact(*page, "separation"), separation);
  page->move_handle(b, page->handles()[b].point + way);
  EXPECT_EQ(fact(*page, "separation"), separation);
}

TEST(Handles, ArcsThatCrossDependOnTheRelativeTurnOnly) {
  const std::unique_ptr<Page> page = page_of(4);
  const std::string crossing = fact(*page, "crossing arcs");
  const Vec3 way(1, 1, 0);
  page->move_handle(a, way);
  EXPECT_EQ(fact(*page, "crossing arcs"), crossing);
  // Aligned cubes: the arcs of one coincide with those of the other, and coinciding arcs do not cross.
  ControlSetter aligned("turn=0,0,0");
  page->describe(aligned);
  EXPECT_EQ(fact(*page, "crossing arcs"), "0");
  page->turn_handle(a, {Real(0.4), Real(0.3), 0});
  EXPECT_NE(fact(*page, "crossing arcs"), "0");
}

/// Small turns add up to any orientation, also through the one where two angles of the setting merge.
TEST(Handles, TurnsAddUp) {
  const std::unique_ptr<Page> page = page_of(4);
  page->move_handle(b, {0, 0, 2});
  const std::string before = fact(*page, "separation");
  constexpr int turns = 32;
  for (int i = 0; i < turns; ++i) page->turn_handle(b, {0, 2 * pi / turns, 0});
  EXPECT_EQ(fact(*page, "separation"), before);
}

TEST(Handles, TheArrowOfAClimbOnlyMoves) {
  const std::unique_ptr<Page> page = page_of(3);
  ASSERT_EQ(page->handles().size(), 1U);
  EXPECT_FALSE(page->handles()[0].turns);
  page->move_handle(0, {0, 0, 3});
  EXPECT_GT(page->handles()[0].point.z(), 1);
}

/// The end of the line that shows the direction.
Vec3 drawn_tip(const Page& page) {
  for (const drawing::Line& line : page.content().drawing.lines) {
    if (line.stroke.role == drawing::Role::Axis && line.stroke.arrow) return line.to;
  }
  return Vec3::Constant(NAN);
}

TEST(Handles, TheArrowOfAClimbIsTakenAtItsTipWhichIsInTheFocus) {
  for (const char* assignment : {"direction=0.45,-0.75,0.55", "direction=1,0,0", "direction=0,0,-2",
                                 "direction=0,0,0", "shape=tetrahedron"}) {
    const std::unique_ptr<Page> page = page_of(3);
    ControlSetter setter(assignment);
    page->describe(setter);
    page->refresh();
    const Vec3 tip = page->handles().at(0).point;
    EXPECT_LT((drawn_tip(*page) - tip).norm(), 1e-4) << assignment;
    const Focus& focus = page->content().focus;
    EXPECT_LT((tip - focus.center).norm(), focus.radius) << assignment;
    // Holding it still does not move it.
    page->move_handle(0, tip);
    EXPECT_LT((page->handles().at(0).point - tip).norm(), 1e-4) << assignment;
  }
}

/// Otherwise the shape would run away from the pointer, and the tip would stay behind it.
TEST(Handles, TheArrowOfAClimbDoesNotMoveTheFrame) {
  const std::unique_ptr<Page> page = page_of(3);
  const Focus first = page->content().focus;
  for (const Vec3& tip : {Vec3(3, 0, 0), Vec3(-3, 0, 0), Vec3(0, 0, 3), Vec3(0, 0, -3)}) {
    page->move_handle(0, tip);
    page->refresh();
    EXPECT_EQ(page->content().focus.center, first.center) << tip.transpose();
    EXPECT_EQ(page->content().focus.radius, first.radius) << tip.transpose();
  }
}

TEST(Handles, AbsentWhereThereIsNothingToDrag) { EXPECT_TRUE(page_of(1)->handles().empty()); }

}  // namespace
}  // namespace cs550::test
