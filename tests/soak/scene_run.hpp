#pragma once
/// @file scene_run.hpp
/// Runs a scene document and says which law of physics it broke.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace cs550::test {

/// Runs a scene to its end. @returns what is wrong with the run, empty if nothing is: the document is
/// refused, a number is not finite, momentum or energy comes from nowhere, or a body is farther away
/// than its energy can have carried it
std::string fault_of(const nlohmann::json& document, const std::filesystem::path& file);

/// The smallest document that still has a fault: without the bodies, steps and properties that the
/// fault does not need. @param file for the attempts; holds the result in the end
nlohmann::json shrunk(nlohmann::json document, const std::filesystem::path& file);

}  // namespace cs550::test
