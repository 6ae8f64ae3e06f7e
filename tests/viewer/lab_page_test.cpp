// The steps that the pages of labs show, and settings at the ends of their ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pages/make_page.hpp"
#include "pages/world/world_page.hpp"

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

/// A mesh with a hole has no walk.
TEST(LabPage, WhereThereAreNoStepsTheLastOneStaysTheLastOne) {
  const std::unique_ptr<Page> page = lab_page(2, {"fault=hole"});
  ASSERT_LT(page->content().step_count, 2);
  page->advance();
  ControlLister lister;
  page->describe(lister);
  EXPECT_NE(lister.text().find("step=last"), std::string::npos) << lister.text();
}

TEST(LabPage, AWalkBeginsOnAFaceTowardsTheEye) {
  for (const char* solid : {"solid=box", "solid=prism", "solid=icosahedron"}) {
    for (const char* merged : {"merged=on", "merged=off"}) {
      const std::unique_ptr<Page> page = lab_page(2, {solid, merged});
      const std::vector<drawing::Polygon>& polygons = page->content().drawing.polygons;
      const auto face = std::find_if(polygons.begin(), polygons.end(), [](const auto& polygon) {
        return polygon.role == drawing::Role::Reference;
      });
      ASSERT_NE(face, polygons.end()) << solid;
      const Vec3 normal = (face->corners[1] - face->corners[0])
                              .cross(face->corners[2] - face->corners[0])
                              .normalized();
      const Vec3 eye = fitted(page->first_view(), Vec3::Zero(), Real(1.15)).eye();
      EXPECT_GT(normal.dot((eye - face->corners[0]).normalized()), 0.5) << solid << ' ' << merged;
    }
  }
}

TEST(LabPage, EverySolidOfLab2IsInTheFirstViewAsAWhole) {
  for (const char* solid : {"box", "prism", "tetrahedron", "icosahedron"}) {
    const std::unique_ptr<Page> page = lab_page(2, {std::string("solid=") + solid});
    const Focus& focus = page->content().focus;
    ASSERT_EQ(page->content().solids.size(), 1U) << solid;
    for (const Vec3& vertex : page->content().solids[0].mesh->vertices) {
      EXPECT_LT((vertex - focus.center).norm(), focus.radius)
          << solid << ", " << vertex.transpose();
    }
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

/// The corners of A and B, which are solids on one page and drawn on another.
std::vector<Vec3> corners_of_bodies(const Content& content) {
  std::vector<Vec3> corners;
  for (const Solid& solid : content.solids) {
    for (const Vec3& vertex : solid.mesh->vertices) corners.push_back(solid.pose.to_world(vertex));
  }
  for (const drawing::Polygon& polygon : content.drawing.polygons) {
    if (polygon.role != drawing::Role::BodyA && polygon.role != drawing::Role::BodyB) continue;
    corners.insert(corners.end(), polygon.corners.begin(), polygon.corners.end());
  }
  return corners;
}

/// Drags move the bodies of labs 4 and 5 up to 4 m from the middle along each axis.
TEST(LabPage, TwoBodiesAreInTheFirstViewHoweverFarApart) {
  const Size canvas{300, 300};
  const Area area{0, 0, 300, 300};
  for (const int lab : {4, 5}) {
    for (const char* place : {"position=4,4,4", "position=4,-4,-4", "position=0,-4,2"}) {
      const std::unique_ptr<Page> page = lab_page(lab, {place, "position_a=-4,4,-1"});
      const Focus& focus = page->content().focus;
      const Projection seen(fitted(page->first_view(), focus.center, focus.radius), canvas, area);
      const std::vector<Vec3> corners = corners_of_bodies(page->content());
      EXPECT_GE(corners.size(), 16U);
      for (const Vec3& corner : corners) {
        const Vec2 pixel = seen.pixel(corner);
        EXPECT_GE(pixel.minCoeff(), -0.5) << "lab " << lab << ", " << place;
        EXPECT_LE(pixel.maxCoeff(), 300.5) << "lab " << lab << ", " << place;
      }
    }
  }
}

TEST(LabPage, NothingIsClippedWhereEdgesMeet) {
  const std::vector<std::string> pair{"shape_a=box", "shape_b=box", "position=0.35,-0.62,0.98",
                                      "turn=38,24,72"};
  ASSERT_EQ(fact_of(*lab_page(4, pair), "winner").substr(0, 5), "edges");
  const std::unique_ptr<Page> clipping = lab_page(5, pair);
  EXPECT_EQ(clipping->content().problem, "");
  EXPECT_EQ(clipping->content().step_count, 1);
  EXPECT_EQ(fact_of(*clipping, "incident face"), "missing");
  EXPECT_NE(fact_of(*clipping, "edge of A"), "missing");
  EXPECT_EQ(fact_of(*clipping, "points kept"), "1");
}

TEST(LabPage, ThePointsOfAManifoldAreNamed) {
  const std::unique_ptr<Page> page = lab_page(5);
  const std::string name = fact_of(*page, "point 1");
  EXPECT_NE(name.find("vertex "), std::string::npos) << name;
  EXPECT_NE(name.find(" on face "), std::string::npos) << name;
}

/// There are fewer colours than boxes.
TEST(LabPage, EachBoxOfAStackHasItsOwnCurve) {
  for (const int lab : {6, 7}) {
    const std::unique_ptr<Page> page = lab_page(lab, {"boxes=10"});
    for (const drawing::Plot& plot : page->content().plots) {
      std::set<std::pair<drawing::Role, bool>> styles;
      for (const drawing::Series& series : plot.series) {
        EXPECT_TRUE(styles.emplace(series.role, series.dashed).second)
            << plot.title << ": " << series.name;
      }
    }
  }
}

TEST(WorldPageOf, ASceneThatFailsHasNothingOfTheOneBefore) {
  WorldPage page("bounce", Isolation::Here);
  page.refresh();
  EXPECT_NE(page.story(), "");
  page.load("no_such_scene");
  page.refresh();
  EXPECT_NE(page.content().problem, "");
  EXPECT_EQ(page.title(), "no_such_scene");
  EXPECT_EQ(page.story(), "");
  page.load("bounce");
  page.refresh();
  EXPECT_EQ(page.content().problem, "");
  EXPECT_NE(page.story(), "");
}

TEST(WorldPageOf, ASceneBeginsWithItsOwnSettingsAndKeepsThemWhenItRestarts) {
  WorldPage page("stack10", Isolation::Here);
  page.refresh();
  const int substeps = page.settings().substeps;
  ControlSetter setter("substeps=9");
  page.describe(setter);
  page.reset();
  EXPECT_EQ(page.settings().substeps, 9);
  page.load("stack10");
  EXPECT_EQ(page.settings().substeps, substeps);
}

TEST(WorldPageOf, CountsTheContactsThatAreAwakeOnceBodiesSleep) {
  WorldPage page("bounce", Isolation::Here);
  page.take_steps(1);
  page.refresh();
  EXPECT_NE(fact_of(page, "contacts"), "missing");
  for (int i = 0; i < 40 && fact_of(page, "asleep") == "missing"; ++i) {
    page.take_steps(30);
    page.refresh();
  }
  ASSERT_NE(fact_of(page, "asleep"), "missing") << "nothing sleeps after 20 s";
  EXPECT_EQ(fact_of(page, "contacts"), "missing");
  EXPECT_NE(fact_of(page, "awake contacts"), "missing");
}

}  // namespace
}  // namespace cs550::test
