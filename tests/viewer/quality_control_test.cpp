// The choice of quality among the settings of the World page.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "cs550/world.hpp"
#include "pages/base/controls.hpp"
#include "pages/world/world_controls.hpp"

namespace cs550::test {
namespace {

using namespace pages;

void set(WorldSettings& settings, const std::string& assignment) {
  ControlSetter setter(assignment);
  describe(settings, setter);
  setter.expect_found();
}

/// What `--list` prints of the choice.
std::string listed_quality(WorldSettings settings) {
  ControlLister lister;
  describe(settings, lister);
  const std::string name = "quality=";
  const std::size_t start = lister.text().find(name);
  if (start == std::string::npos) return "missing";
  const std::size_t value = start + name.size();
  return lister.text().substr(value, lister.text().find_first_of(" \n", value) - value);
}

TEST(QualityControl, ChoosesTheNamedSettingsAndNothingElse) {
  WorldSettings settings;
  settings.gravity = {0, 0, -1};
  settings.sleeping = true;
  set(settings, "quality=game");
  EXPECT_TRUE(has_quality(settings, Quality::Game));
  EXPECT_EQ(settings.substeps, game_settings().substeps);
  EXPECT_EQ(settings.gravity, Vec3(0, 0, -1));
  EXPECT_TRUE(settings.sleeping);
  set(settings, "quality=accurate");
  EXPECT_TRUE(has_quality(settings, Quality::Accurate));
  EXPECT_EQ(settings.gravity, Vec3(0, 0, -1));
}

TEST(QualityControl, ShowsWhichNamedSettingsAreChosen) {
  EXPECT_EQ(listed_quality(accurate_settings()), "accurate");
  EXPECT_EQ(listed_quality(game_settings()), "game");
  WorldSettings settings = game_settings();
  set(settings, "substeps=7");
  EXPECT_EQ(listed_quality(settings), "custom");
  set(settings, "substeps=" + std::to_string(game_settings().substeps));
  EXPECT_EQ(listed_quality(settings), "game");
}

TEST(QualityControl, CustomChangesNothing) {
  WorldSettings settings = game_settings();
  settings.iterations = 5;
  set(settings, "quality=custom");
  EXPECT_EQ(settings.iterations, 5);
  EXPECT_EQ(settings.substeps, game_settings().substeps);
}

TEST(QualityControl, RefusesAnotherNameAndListsTheChoices) {
  WorldSettings settings;
  try {
    set(settings, "quality=best");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    for (const char* const name : {"quality", "best", "accurate", "game"}) {
      EXPECT_NE(message.find(name), std::string::npos) << message;
    }
  }
  EXPECT_TRUE(has_quality(settings, Quality::Accurate));
}

}  // namespace
}  // namespace cs550::test
