#pragma once
/// @file scene_document.hpp
/// The JSON text of a scene as a tree of values.

#include <istream>
#include <nlohmann/json.hpp>

namespace cs550 {

/// Parses a scene file. Throws SceneFault with the JSON path for a key that occurs twice in one object,
/// for a number that no double can hold, and for lists or objects nested deeper than any scene needs.
/// Throws nlohmann::json::parse_error, with line and column, for text that is not JSON.
nlohmann::json parse_scene_document(std::istream& text);

}  // namespace cs550
