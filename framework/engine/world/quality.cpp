#include <tuple>

#include "cs550/world.hpp"

namespace cs550 {

namespace {

/// The members that a quality determines.
template <class Settings>
auto determined(Settings& settings) {
  return std::tie(settings.substeps, settings.iterations, settings.relax_iterations,
                  settings.pass_order, settings.contact_hertz, settings.contact_damping_ratio,
                  settings.over_relaxation, settings.rolling_resistance);
}

WorldSettings settings_of(Quality quality) {
  return quality == Quality::Game ? game_settings() : accurate_settings();
}

}  // namespace

WorldSettings accurate_settings() { return {}; }

WorldSettings game_settings() {
  WorldSettings settings;
  settings.substeps = 3;
  settings.iterations = 2;
  settings.relax_iterations = 1;
  settings.pass_order = PassOrder::StepByStep;
  settings.contact_hertz = 40;
  settings.contact_damping_ratio = 30;
  settings.over_relaxation = Real(1.3);
  settings.rolling_resistance = Real(3e-3);
  return settings;
}

void set_quality(WorldSettings& settings, Quality quality) {
  const WorldSettings named = settings_of(quality);
  determined(settings) = determined(named);
}

bool has_quality(const WorldSettings& settings, Quality quality) {
  const WorldSettings named = settings_of(quality);
  return determined(settings) == determined(named);
}

}  // namespace cs550
