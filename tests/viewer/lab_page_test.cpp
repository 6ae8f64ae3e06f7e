// The steps that the pages of labs show, and settings at the ends of their ranges.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "pages/make_page.hpp"

namespace cs550::test {
namespace {

using namespace pages;

std::unique_ptr<Page> lab_page(int lab, const std::vector<std::string>& assignments = {}) {
  PageChoice choice;
  choice.lab = lab;
  std::unique_ptr<Page> page = make_page(choice);
  for (const std::string& assignment : assignments) {
    ControlSetter setter(assignment);
    page->describe(setter);
    setter.expect_found();
  }
  page->refresh();
  return page;
}

/// A fact on the panel.
std::string fact_of(const Page& page, const std::string& name) {
  for (const Fact& fact : page.content().facts) {
    if (fact.name == name) return fact.value;
  }
  return "missing";
}

TEST(LabPage, TheStepAfterOneBeyondTheEndIsTheFirst) {
  for (const char* beyond : {"step=last", "step=37", "step=40"}) {
    const std::unique_ptr<Page> page = lab_page(5, {beyond});
    EXPECT_EQ(fact_of(*page, "shown"), "the manifold") << beyond;
    page->advance();
    page->refresh();
    EXPECT_EQ(fact_of(*page, "shown"), "the incident face") << beyond;
  }
}

}  // namespace
}  // namespace cs550::test
