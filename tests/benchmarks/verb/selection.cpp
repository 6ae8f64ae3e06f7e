#include "benchmarks/verb/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace cs550::bench {
namespace {

const std::string frontier_scenes[] = {"S1", "S3", "S5"};

std::regex expression_of(const std::string& filter) {
  try {
    return std::regex(filter);
  } catch (const std::regex_error&) {
    throw Misuse(
        fmt::format("--filter '{}' is not a regular expression.\n"
                    "  For example: ./cs550 bench --filter 'support|S1'",
                    filter));
  }
}

std::string scene_name(const NamedScene& scene) { return std::string("scene/") + scene.name; }
std::string frontier_name(const NamedScene& scene) { return std::string("frontier/") + scene.name; }
std::string scaling_name(const ScaledScene& family) { return std::string("step/") + family.name; }
constexpr const char* memory_name = "memory";

bool has_frontier(const NamedScene& scene) {
  return std::find(std::begin(frontier_scenes), std::end(frontier_scenes), scene.name) !=
         std::end(frontier_scenes);
}

}  // namespace

std::vector<std::string> Selection::names() const {
  std::vector<std::string> names;
  for (const Stage& stage : stages) names.push_back(stage.name);
  for (const NamedScene& scene : scenes) names.push_back(scene_name(scene));
  for (const NamedScene& scene : frontiers) names.push_back(frontier_name(scene));
  for (const ScaledScene& family : scaling) names.push_back(scaling_name(family));
  if (memory) names.emplace_back(memory_name);
  return names;
}

Selection select(const std::string& filter, bool with_frontiers) {
  const std::regex expression = expression_of(filter);
  const auto matches = [&](const std::string& name) { return std::regex_search(name, expression); };
  Selection selection;
  for (const Stage& stage : all_stages()) {
    if (matches(stage.name)) selection.stages.push_back(stage);
  }
  for (const NamedScene& scene : compared_scenes()) {
    if (matches(scene_name(scene))) selection.scenes.push_back(scene);
    if (with_frontiers && has_frontier(scene) && matches(frontier_name(scene))) {
      selection.frontiers.push_back(scene);
    }
  }
  for (const ScaledScene& family : scaled_scenes()) {
    if (matches(scaling_name(family))) selection.scaling.push_back(family);
  }
  selection.memory = matches(memory_name);
  if (selection.names().empty()) {
    throw Misuse(
        fmt::format("--filter '{}' matches no benchmark.\n"
                    "  ./cs550 bench --list{} prints their names.",
                    filter, with_frontiers ? " --plot" : ""));
  }
  return selection;
}

}  // namespace cs550::bench
