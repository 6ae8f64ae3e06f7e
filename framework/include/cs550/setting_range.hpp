#pragma once
/// @file setting_range.hpp
/// The values that a world accepts for its settings.

#include <optional>
#include <string_view>

#include "cs550/math.hpp"

namespace cs550 {

/// The least and the largest value of a setting.
struct SettingRange {
  Real least = 0;  ///< in the setting's own unit
  Real most = 0;   ///< at least as large
};

/// The range of a setting that is a number, or of each component of a vector; empty for others.
/// @param name as in a scene file: "substeps"
std::optional<SettingRange> setting_range(std::string_view name);

}  // namespace cs550
