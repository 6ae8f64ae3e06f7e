/// Grades one lab of one submission, or runs the milestones on its labs together.
#include <CLI/CLI.hpp>

#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>

#include "autograder/grader/grade_lab/compile.hpp"
#include "autograder/grader/grade_lab/judging.hpp"
#include "autograder/grader/grade_lab/milestones.hpp"
#include "autograder/grader/grade_lab/options.hpp"
#include "autograder/grader/grade_lab/own_tests.hpp"
#include "files/interruption.hpp"
#include "files/output_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cs550::grader;
namespace files = cs550::files;
using Json = nlohmann::ordered_json;

enum ExitCode { Graded = 0, NotGraded = 1, WrongUsage = 2 };

constexpr std::size_t longest_message_shown = 4096;  ///< bytes

/// Prints the isolation that a wish leads to, and ends the program.
void add_probe(CLI::App& app) {
  const auto probe = [](const std::string& wish) {
    std::cout << to_string(chosen_isolation(wish)) << '\n';
    throw CLI::Success();
  };
  app.add_option_function<std::string>("--probe", probe,
                                       "only print which isolation this --isolation leads to")
      ->trigger_on_parse();
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("LAB", options.lab, "number of the lab")->required()->check(CLI::Range(1, 99));
  app.add_flag("--milestones", options.milestones,
               "run the milestones of labs 1 to LAB on these labs together; the submission is a "
               "folder with a folder labN_topic for each");
  app.add_flag("--own-tests", options.own_tests,
               "grade my_tests.cpp, the student's own tests, by the known mistakes that it finds");
  app.add_flag("--challenge", options.challenge,
               "once every test passes, count the lab's challenge too");
  app.add_option("--submission", options.submission, "folder with the lab's files")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--work", options.work, "folder for this run; it is emptied first")->required();
  app.add_option("--results", options.results, "JSON file to write")->required();
  app.add_option("--salt", options.salt, "added to the seeds of all tests; 0: the published seeds");
  app.add_option("--filter", options.filter, "only tests with such names, as in GoogleTest");
  app.add_option("--wall", options.wall, "longest time for one test (s)")
      ->check(CLI::Range(1, 3600));
  app.add_option("--cpu", options.cpu, "processor time of a test (s)")->check(CLI::Range(1, 3600));
  app.add_option("--memory", options.memory, "address space of a test's submission (MB)")
      ->check(CLI::Range(256, 1 << 20));
  app.add_option("--lab-time", options.lab_time,
                 "longest time for compilation and all tests together (s)")
      ->check(CLI::Range(1, 3600));
  app.add_option("--jobs", options.jobs,
                 "runs of this program at the same time, which share a limit of processes")
      ->check(CLI::Range(1, 256));
  app.add_option("--isolation", options.isolation)
      ->check(CLI::IsMember({"auto", "bubblewrap", "plain"}));
  add_probe(app);
}

/// "lab3_hill_climbing". @throws std::runtime_error if there is no such lab
std::string lab_name(int lab) {
  const std::string prefix = "lab" + std::to_string(lab) + '_';
  for (const fs::path& folder : fs::directory_iterator(CS550_GRADED_TESTS)) {
    if (folder.filename().string().starts_with(prefix)) return folder.filename().string();
  }
  throw std::runtime_error("there is no lab " + std::to_string(lab));
}

/// As the lab's manifest lists them: [{name, points, step, hidden, long}].
nlohmann::json graded_tests(const std::string& lab_name) {
  std::ifstream stream(fs::path(CS550_GRADED_TESTS) / lab_name / "manifest.json");
  return nlohmann::json::parse(stream).at("tests");
}

/// A message without the line that names the file of its picture, which no reader of the record has.
std::string without_picture(const std::string& message) {
  static const std::regex line(R"((^|\n) *picture +[^\n]*\.svg(?=\n|$))");
  return std::regex_replace(message, line, "");
}

/// Status and message of a test that has no result.
std::pair<std::string, std::string> without_result(const Compilation& compilation) {
  if (compilation.succeeded) return {"crashed", "the judge ended during this test"};
  if (compilation.was_stopped) return {"timeout", compilation.errors};
  return {"not_compiled", "it does not compile"};
}

/// One test of the record, from its line in the manifest and its row in the judge's results.
Json record_of(int lab, const Json& test, const nlohmann::json& rows,
               const Compilation& compilation) {
  const std::string name = test.at("name");
  const auto [status, message] = without_result(compilation);
  Json record{{"name", "Lab" + std::to_string(lab) + "." + name},
              {"step", test.at("step")},
              {"points", test.at("points")},
              {"earned", 0},
              {"status", status},
              {"hidden", test.at("hidden")},
              {"seconds", 0.0},
              {"message", message}};
  if (!rows.contains(name) || rows[name]["status"] == "running") return record;
  const nlohmann::json& row = rows[name];
  record["earned"] = row.at("earned");
  record["status"] = row.value("ended_as", row.at("status").get<std::string>());
  record["seconds"] = row.at("seconds");
  record["message"] =
      readable_text(without_picture(row.at("message").get<std::string>()), longest_message_shown);
  return record;
}

/// Adds what its first failing test looks like, if that is a visible one that draws a picture.
void add_picture(Json& records, const fs::path& pictures) {
  constexpr std::uintmax_t largest = 100'000;  // bytes
  for (Json& record : records) {
    const fs::path file = pictures / (record["name"].get<std::string>() + ".svg");
    std::error_code absent;
    const std::uintmax_t size = fs::file_size(file, absent);
    if (record["hidden"] || record["status"] == "passed" || absent || size > largest) continue;
    std::ifstream stream(file);
    record["picture"] = std::string(std::istreambuf_iterator<char>(stream), {});
    return;
  }
}

Json sum_of(const Json& tests, const std::function<bool(const Json&)>& counts) {
  int points = 0;
  int earned = 0;
  for (const Json& test : tests) {
    if (!counts(test)) continue;
    points += test.at("points").get<int>();
    earned += test.at("earned").get<int>();
  }
  return {{"points", points}, {"earned", earned}};
}

bool matches(const std::string& filter, const nlohmann::json& rows, const std::string& name) {
  return filter == "*" || rows.contains(name);
}

Json grade(const Options& options) {
  const std::string name = lab_name(options.lab);
  const fs::path work = empty_work_folder(options);
  Order order = order_for(options);
  order.lab = options.lab;
  order.libraries = {work / "run" / ("lab" + std::to_string(options.lab) + "_submission.so")};

  const nlohmann::json tests = graded_tests(name);
  const Compilation compilation = compile(options.submission, name, order.libraries.front(), order);
  const nlohmann::json rows = compilation.succeeded
                                  ? run_judge(order, tests.size(), options.filter, work)
                                  : nlohmann::json::object();
  Json records = Json::array();
  for (const Json test : tests) {
    if (!compilation.succeeded || matches(options.filter, rows, test.at("name"))) {
      records.push_back(record_of(options.lab, test, rows, compilation));
    }
  }
  add_picture(records, work / "pictures");
  const Json all = sum_of(records, [](const Json&) { return true; });
  Json result{
      {"lab", options.lab},
      {"isolation", to_string(order.isolation)},
      {"compiler", CS550_COMPILER_NAME},
      {"seed", options.salt == 0 ? "published" : "salt " + std::to_string(options.salt)},
      {"compile",
       {{"ok", compilation.succeeded},
        {"seconds", compilation.seconds},
        {"errors", compilation.errors}}},
      {"tests", records},
      {"points", all.at("points")},
      {"earned", all.at("earned")},
      {"visible", sum_of(records, [](const Json& test) { return !test.at("hidden"); })},
      {"hidden", sum_of(records, [](const Json& test) -> bool { return test.at("hidden"); })}};
  const bool is_finished = options.filter == "*" && all.at("earned") == all.at("points");
  if (options.challenge && is_finished) result["challenge"] = run_challenge(order, work);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Grades one lab of one submission"};
  Options options;
  add_options(app, options);
  files::watch_for_interruption(files::SecondSignal::IsIgnored);  // `grade` passes them on
  try {
    app.parse(argc, argv);
    const Json record = options.milestones  ? run_milestones(options)
                        : options.own_tests ? grade_own_tests(options, lab_name(options.lab))
                                            : grade(options);
    files::write_file(options.results,
                      record.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    return Graded;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? Graded : WrongUsage;
  } catch (const std::exception& error) {
    std::cerr << "grade_lab: " << error.what() << '\n';
    return NotGraded;
  }
}
