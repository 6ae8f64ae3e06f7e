#include "autograder/grader/grade_lab/milestones.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "autograder/grader/grade_lab/compile.hpp"
#include "autograder/grader/grade_lab/judging.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t longest_message_shown = 4096;  ///< bytes

/// The N of "labN_topic"; 0 if that is not how it begins.
int lab_number(const std::string& name) {
  return name.starts_with("lab") ? std::atoi(name.c_str() + 3) : 0;
}

/// The folder names of all labs, by number.
std::map<int, std::string> all_labs() {
  std::map<int, std::string> labs;
  for (const fs::path& folder : fs::directory_iterator(CS550_GRADED_TESTS)) {
    const std::string name = folder.filename().string();
    if (lab_number(name) > 0) labs[lab_number(name)] = name;
  }
  return labs;
}

/// Those that have a record, up to a lab.
std::vector<std::string> milestones_until(int lab) {
  std::vector<std::string> names;
  for (const fs::path& record : fs::directory_iterator(CS550_TRAJECTORIES)) {
    if (lab_number(record.stem().string()) <= lab) names.push_back(record.stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool is_over(const Order& order) { return std::chrono::steady_clock::now() >= order.deadline; }

/// The labs of a submission, compiled together.
struct Assembly {
  Compilation all;
  int stopped = std::numeric_limits<int>::max();  ///< the first lab whose compiler was stopped
};

/// Compiles the labs into `order.libraries`, with starters for those that are missing.
Assembly assemble(const Options& options, const fs::path& folder, Order& order) {
  Assembly assembly;
  Compilation& all = assembly.all;
  all.succeeded = true;
  for (const auto& [number, name] : all_labs()) {
    const std::string lab = "lab" + std::to_string(number);
    const fs::path library = folder / (lab + ".so");
    order.libraries.push_back(library);
    bool is_there = false;
    bool was_stopped = false;
    if (number <= options.lab) {
      const Compilation one = compile(options.submission / name, name, library, order);
      all.seconds += one.seconds;
      is_there = one.succeeded;
      was_stopped = one.was_stopped;
      if (was_stopped) assembly.stopped = std::min(assembly.stopped, number);
    }
    if (is_there) continue;
    fs::copy_file(fs::path(CS550_LAB_FOLDER) / ("lib" + lab + "_stub.so"), library);
    if (number > options.lab) continue;
    all.succeeded = false;
    all.errors += (all.errors.empty() ? "" : "\n") + std::string("lab ") + std::to_string(number) +
                  (is_over(order) ? " was not compiled, since the time for the whole lab is over"
                   : was_stopped  ? " was not compiled: the compiler was stopped"
                                  : " does not compile") +
                  "; its starter takes its place";
  }
  return assembly;
}

/// @param stopped the lab from which on a milestone may lack what was not compiled for lack of time
Json record_of(const std::string& name, const nlohmann::json& rows, const Order& order,
               int stopped) {
  Json record{{"name", "Milestone." + name},
              {"step", "L" + std::to_string(lab_number(name))},
              {"points", 0},
              {"earned", 0},
              {"status", "crashed"},
              {"hidden", false},
              {"seconds", 0.0},
              {"message", "the judge ended during this milestone"}};
  if (lab_number(name) >= stopped) {
    record["status"] = "timeout";
    record["message"] = "the compiler of a lab that it needs was stopped";
    return record;
  }
  if (!rows.contains(name) || rows[name]["status"] == "running") {
    if (!is_over(order)) return record;
    record["status"] = "timeout";
    record["message"] = "the time for the whole lab is over";
    return record;
  }
  const nlohmann::json& row = rows[name];
  record["status"] = row.value("ended_as", row.at("status").get<std::string>());
  record["seconds"] = row.at("seconds");
  record["message"] = readable_text(row.at("message").get<std::string>(), longest_message_shown);
  return record;
}

}  // namespace

Json run_milestones(const Options& options) {
  const fs::path work = empty_work_folder(options);
  Order order = order_for(options);
  const Assembly assembly = assemble(options, work / "run", order);
  const Compilation& compilation = assembly.all;
  const std::vector<std::string> names = milestones_until(options.lab);
  std::string filter;
  for (const std::string& name : names)
    filter += (filter.empty() ? "Milestone." : ":Milestone.") + name;
  const nlohmann::json rows = run_judge(order, names.size(), filter, work);
  Json tests = Json::array();
  for (const std::string& name : names) {
    tests.push_back(record_of(name, rows, order, assembly.stopped));
  }
  return {{"lab", 0},
          {"isolation", to_string(order.isolation)},
          {"compiler", CS550_COMPILER_NAME},
          {"seed", "published"},
          {"compile",
           {{"ok", compilation.succeeded},
            {"seconds", compilation.seconds},
            {"errors", compilation.errors}}},
          {"tests", tests}};
}

}  // namespace cs550::grader
