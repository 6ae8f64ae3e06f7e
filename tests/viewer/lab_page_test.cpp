// The steps that the pages of labs show, and settings at the ends of their ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

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

TEST(LabPage, ARunEndsWithItsDuration) {
  for (const char* seconds : {"seconds=5", "seconds=0.5", "seconds=7", "seconds=20"}) {
    const std::unique_ptr<Page> page = lab_page(1, {seconds});
    const double end = std::stod(std::string(seconds).substr(8));
    EXPECT_EQ(page->content().step_count, std::lround(60 * end) + 1) << seconds;
  }
}

TEST(LabPage, ABodyWithoutSpinHasNumbersAndAPicture) {
  const std::unique_ptr<Page> page = lab_page(1, {"spin=0,0,0"});
  for (const char* name : {"energy, explicit", "energy, midpoint", "|L|, explicit"}) {
    EXPECT_EQ(fact_of(*page, name), "0.00 %") << name;
  }
  EXPECT_FALSE(page->content().drawing.polygons.empty());
  for (const std::string& note : page->content().drawing.notes) {
    EXPECT_EQ(note.find("not finite"), std::string::npos) << note;
  }
}

}  // namespace
}  // namespace cs550::test
