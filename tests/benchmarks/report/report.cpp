#include "benchmarks/report/report.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace cs550::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const SceneRun& run) {
  const Quality& quality = run.quality;
  return {{"engine", run.engine},
          {"effort", run.effort},
          {"seconds", run.seconds},
          {"deepest", quality.deepest},
          {"deep_pairs", quality.deep_pairs},
          {"kinetic_energy", quality.kinetic_energy},
          {"drift", quality.drift ? Json(*quality.drift) : Json()},
          {"lost_bodies", quality.lost_bodies}};
}

Json json_of(const std::vector<SceneRun>& runs) {
  Json list = Json::array();
  for (const SceneRun& run : runs) list.push_back(json_of(run));
  return list;
}

Json json_of(const std::vector<Cost>& costs) {
  Json list = Json::array();
  for (const Cost& cost : costs) list.push_back({{"n", cost.n}, {"seconds", cost.seconds}});
  return list;
}

/// support/climb of support/climb/128
std::string family_of(const std::string& name) { return name.substr(0, name.rfind('/')); }

}  // namespace

std::vector<FittedFamily> fitted_families(const Report& report) {
  std::vector<Scaling> families;
  for (const StageCost& stage : report.stages) {
    if (stage.n == 0) continue;
    const std::string name = family_of(stage.name);
    if (families.empty() || families.back().name != name) families.push_back({name, {}});
    families.back().costs.push_back({stage.n, stage.seconds});
  }
  for (const Scaling& scaling : report.scaling)
    families.push_back({"step/" + scaling.name, scaling.costs});

  std::vector<FittedFamily> fitted;
  for (const auto& [name, costs] : families) {
    const auto [least, most] = std::minmax_element(
        costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.n < b.n; });
    if (least->n < most->n) fitted.push_back({name, least->n, most->n, fit_power_law(costs)});
  }
  return fitted;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

std::string processor_model() {
  std::ifstream lines("/proc/cpuinfo");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  }
  return "unknown processor";
}

std::string to_json(const Report& report) {
  Json json = {{"date", report.date},        {"processor", report.processor},
               {"steps", report.steps},      {"rounds", report.rounds},
               {"stages", Json::array()},    {"exponents", Json::array()},
               {"scenes", Json::array()},    {"thread_gains", Json::array()},
               {"frontiers", Json::array()}, {"scaling", Json::array()}};
  for (const StageCost& stage : report.stages) {
    json["stages"].push_back({{"name", stage.name}, {"n", stage.n}, {"seconds", stage.seconds}});
  }
  for (const FittedFamily& family : fitted_families(report)) {
    json["exponents"].push_back({{"name", family.name},
                                 {"smallest", family.smallest},
                                 {"largest", family.largest},
                                 {"factor", family.law.factor},
                                 {"exponent", family.law.exponent}});
  }
  for (const SceneComparison& scene : report.scenes) {
    json["scenes"].push_back(
        {{"scene", scene.scene}, {"title", scene.title}, {"runs", json_of(scene.runs)}});
  }
  for (const ThreadGain& gain : report.thread_gains) {
    json["thread_gains"].push_back({{"scene", gain.scene},
                                    {"engine", gain.engine},
                                    {"threads", gain.threads},
                                    {"seconds_alone", gain.seconds_alone},
                                    {"seconds_shared", gain.seconds_shared},
                                    {"seconds_copies", gain.seconds_copies}});
  }
  for (const Frontier& frontier : report.frontiers) {
    json["frontiers"].push_back({{"scene", frontier.scene}, {"runs", json_of(frontier.runs)}});
  }
  for (const Scaling& scaling : report.scaling) {
    json["scaling"].push_back({{"name", scaling.name}, {"costs", json_of(scaling.costs)}});
  }
  if (report.memory) {
    json["memory"] = {{"bytes_per_body", report.memory->bytes_per_body},
                      {"bytes_per_contact", report.memory->bytes_per_contact},
                      {"allocations_per_step", report.memory->allocations_per_step}};
  }
  return json.dump(1) + '\n';
}

}  // namespace cs550::bench
