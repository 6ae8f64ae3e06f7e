#pragma once
/// @file settings_ranges.hpp
/// The ranges of a world's settings, for scenes and for programs.

#include "cs550/world.hpp"
#include "engine/number_range.hpp"
#include "engine/threads/thread_team.hpp"

namespace cs550 {

/// Calls `visit(name, member, range...)` for each setting that is a number. The range is a Range, or the least
/// and the largest value.
template <class Settings, class Visit>
void for_each_range(Settings& settings, const Visit& visit) {
  constexpr int most_passes = 1000;
  visit("gravity", settings.gravity, Range::Any);
  visit("length_unit", settings.length_unit, Range::Positive);
  visit("substeps", settings.substeps, 1, most_passes);
  visit("iterations", settings.iterations, 0, most_passes);
  visit("relax_iterations", settings.relax_iterations, 0, most_passes);
  visit("threads", settings.threads, 1, most_threads);
  visit("contact_hertz", settings.contact_hertz, Range::Positive);
  visit("contact_damping_ratio", settings.contact_damping_ratio, Range::NotNegative);
  visit("baumgarte", settings.baumgarte, Range::ZeroToOne);
  visit("slop", settings.slop, Range::NotNegative);
  visit("max_push_speed", settings.max_push_speed, Range::NotNegative);
  visit("restitution_threshold", settings.restitution_threshold, Range::NotNegative);
  visit("restitution_iterations", settings.restitution_iterations, 0, most_passes);
  visit("over_relaxation", settings.over_relaxation, 1.0, 1.9);
  visit("rolling_resistance", settings.rolling_resistance, Range::NotNegative);
}

/// @throws std::invalid_argument for a setting outside its range; the message names it
void check(const WorldSettings& settings);

}  // namespace cs550
