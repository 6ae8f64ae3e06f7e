// Milestones: the compared quantities, and the messages for deviations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "helpers/scratch_folder.hpp"
#include "milestones/record.hpp"

namespace cs550::milestones {
namespace {

Scene scene_of(const Milestone& milestone) {
  const SceneResult found = find_scene(milestone.scene);
  EXPECT_TRUE(found) << found.error;
  return found.scene;
}

TEST(Distance, IsTheLengthOfTheDifference) {
  EXPECT_DOUBLE_EQ(distance({3}, {-1}), 4);
  EXPECT_DOUBLE_EQ(distance({1, 2, 3}, {1, 5, 7}), 5);
}

TEST(Distance, OfOrientationsIsTheAngleBetweenThem) {
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(distance({1, 0, 0, 0}, {half, half, 0, 0}), std::acos(-1) / 2, 1e-12);
  EXPECT_NEAR(distance({1, 0, 0, 0}, {0, 0, 1, 0}), std::acos(-1), 1e-12);
  EXPECT_EQ(distance({half, 0, half, 0}, {-half, 0, -half, 0}), 0);
}

TEST(Distance, OfNanIsNan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(distance({nan}, {1})));
  EXPECT_TRUE(std::isnan(distance({1, 0, 0, 0}, {nan, 0, 0, 0})));
}

/// A quantity that is 1 for a second, as a run and as a record.
Track constant_track() {
  Track track;
  for (int i = 0; i <= 10; ++i) {
    track.times.push_back(0.1 * i);
    track.observations.push_back({{"crate: height", "m", {1}, 0.02}});
  }
  return track;
}

TEST(Comparison, AgreesWithItself) {
  const Comparison same = compare(constant_track(), to_record(constant_track()));
  EXPECT_TRUE(same.agrees) << same.sentence;
  EXPECT_DOUBLE_EQ(same.until, 1);
}

TEST(Comparison, ReportsTheFirstDifferenceAndItsSize) {
  Track track = constant_track();
  track.observations[4][0].values = {1.019};  // within the tolerance
  track.observations[7][0].values = {1.25};
  track.observations[9][0].values = {50};
  const Comparison comparison = compare(track, to_record(constant_track()));
  EXPECT_FALSE(comparison.agrees);
  EXPECT_DOUBLE_EQ(comparison.until, track.times[6]);
  for (const char* part :
       {"t = 0.7 s", "crate: height", "expected 1 m, got 1.25 m", "difference 0.25 m"}) {
    EXPECT_NE(comparison.sentence.find(part), std::string::npos) << comparison.sentence;
  }
}

TEST(Comparison, NanDeparts) {
  Track track = constant_track();
  track.observations[2][0].values = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(compare(track, to_record(constant_track())).agrees);
}

TEST(Comparison, ARunThatEndsEarlyReportsItsProblem) {
  Track track = constant_track();
  track.times.resize(5);
  track.observations.resize(5);
  track.problem = "not implemented: L4.4";
  const Comparison comparison = compare(track, to_record(constant_track()));
  EXPECT_FALSE(comparison.agrees);
  EXPECT_EQ(comparison.sentence, track.problem);
}

TEST(Records, FitIntoTwoHundredKilobytes) {
  for (const Milestone& milestone : all_milestones()) {
    ASSERT_TRUE(std::filesystem::exists(record_file(milestone))) << record_file(milestone);
    EXPECT_LE(std::filesystem::file_size(record_file(milestone)), 200'000U) << milestone.name();
  }
}

TEST(Records, EveryLabHasOne) {
  for (int lab = 1; lab <= 7; ++lab) EXPECT_FALSE(milestones_of(lab).empty()) << lab;
}

TEST(Milestones, AreWatchedWhereTheirLabIsSeen) {
  for (const Milestone& milestone : all_milestones()) {
    const std::string command = command_to_watch(milestone);
    const bool shows_page =
        command == "./cs550 view --lab " + std::to_string(milestone.lab) + " --student";
    const bool shows_scene = command == "./cs550 view " + milestone.scene + " --student";
    EXPECT_TRUE(milestone.lab >= 3 && milestone.lab <= 5 ? shows_page : shows_scene) << command;
  }
}

/// The same bodies in reverse order, so that all sums of the solver are computed in another order.
Scene turned_round(Scene scene) {
  std::reverse(scene.bodies.begin(), scene.bodies.end());
  std::reverse(scene.body_names.begin(), scene.body_names.end());
  return scene;
}

void sort_by_name(Track& track) {
  for (Observation& seen : track.observations) {
    std::sort(seen.begin(), seen.end(),
              [](const Quantity& a, const Quantity& b) { return a.name < b.name; });
  }
}

TEST(Milestones, AnotherOrderOfSummationReachesThem) {
  for (const Milestone& milestone : milestones_of(7)) {
    Track usual = run(milestone, scene_of(milestone));
    Track reversed = run(milestone, turned_round(scene_of(milestone)));
    sort_by_name(usual);
    sort_by_name(reversed);
    const Comparison comparison = compare(reversed, to_record(usual));
    EXPECT_TRUE(comparison.agrees) << milestone.name() << ": " << comparison.sentence;
    RecordProperty(milestone.name(), comparison.sentence);
  }
}

/// Several mistakes at once, so that every milestone is affected by one of them.
Scene spoiled(Scene scene) {
  scene.settings.gravity += Vec3(0, 0, 1);
  scene.settings.solver = SolverKind::Naive;
  for (BodyDef& body : scene.bodies) {
    body.angular_velocity *= Real(0.8);
    body.restitution *= Real(0.8);
  }
  return scene;
}

TEST(Milestones, AWrongEngineReachesNone) {
  for (const Milestone& milestone : all_milestones()) {
    const Track track = run(milestone, spoiled(scene_of(milestone)));
    EXPECT_FALSE(compare(track, read_record(record_file(milestone))).agrees) << milestone.name();
  }
}

TEST(Record, NamesTheCellThatIsNoNumber) {
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder / "record.csv";
  for (const std::string cell : {"abc", "", "1,5", "1e999", "2x"}) {
    std::ofstream(file) << "time (s);height (m)\n0;1\n0.1;" << cell << "\n0.2;2\n";
    if (cell.empty()) std::ofstream(file) << "time (s);height (m)\n0;1\n;2\n";
    try {
      read_record(file);
      ADD_FAILURE() << "read \"" << cell << '"';
    } catch (const std::runtime_error& error) {
      const std::string place = cell.empty() ? "line 3, cell 1" : "line 3, cell 2";
      EXPECT_EQ(error.what(),
                file.string() + ": " + place + ": expected a number, found \"" + cell + '"');
    }
  }
}

}  // namespace
}  // namespace cs550::milestones
