// The page of a running scene on the starters: every function of a lab throws NotImplemented.
#include "pages/world/world_page.hpp"

#include <gtest/gtest.h>

namespace cs550::test {
namespace {

using namespace pages;

TEST(WorldOnStarters, GoesOnWhenABoxIsThrown) {
  WorldPage page("free_spin", Isolation::Here);
  page.refresh();
  page.throw_box(Vec3(0, 0, 5), Vec3(0, 0, 1));
  page.take_steps(1);
  page.refresh();
  EXPECT_EQ(page.content().problem, "");
  EXPECT_EQ(page.frame().step, 1);
  EXPECT_EQ(page.frame().bodies.size(), 2U);
}

}  // namespace
}  // namespace cs550::test
