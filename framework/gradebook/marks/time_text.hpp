#pragma once
/// @file time_text.hpp
/// Times as text in ISO 8601.

#include <chrono>
#include <optional>
#include <string>

#include "gradebook/course/course.hpp"

namespace cs550::gradebook {

/// "2026-10-12T21:59:00Z", or with an offset "+02:00"; nothing for any other text. Fractions of a second
/// are dropped.
std::optional<Time> parse_time(const std::string& text);

/// "2026-10-12T21:59:00Z", or with an offset from UTC "2026-10-12T23:59:00+02:00".
std::string to_text(Time time, std::chrono::minutes offset = std::chrono::minutes(0));

}  // namespace cs550::gradebook
