#include "gradebook/records/record_json.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

Json json_of(const TestResult& test) {
  Json json{{"name", test.name},       {"step", test.step},      {"points", test.points},
            {"earned", test.earned},   {"status", test.status},  {"hidden", test.hidden},
            {"seconds", test.seconds}, {"message", test.message}};
  if (!test.picture.empty()) json["picture"] = test.picture;
  return json;
}

TestResult test_of(const Json& json) {
  constexpr std::size_t longest_message = 16 * 1024;
  return {
      json.at("name"),          json.at("step"),
      json.at("points"),        json.at("earned"),
      json.at("status"),        json.at("hidden"),
      json.at("seconds"),       shortened(json.at("message").get<std::string>(), longest_message),
      json.value("picture", "")};
}

std::vector<TestResult> tests_of(const Json& json) {
  std::vector<TestResult> tests;
  for (const Json& test : json.at("tests")) tests.push_back(test_of(test));
  return tests;
}

Json json_of(const OwnTests& own) {
  return {{"compiled", own.compiled}, {"mistakes", own.mistakes},
          {"caught", own.caught},     {"reference_failures", own.fails_reference ? 1 : 0},
          {"message", own.message},   {"not_graded", own.not_graded},
          {"stopped", own.stopped}};
}

OwnTests own_tests_of(const Json& json) {
  constexpr std::size_t longest_message = 4096;
  OwnTests own{json.at("compiled"),
               json.at("mistakes"),
               json.at("caught"),
               json.at("reference_failures") != 0,
               shortened(json.at("message").get<std::string>(), longest_message),
               json.value("not_graded", ""),
               json.value("stopped", false)};
  if (own.caught < 0 || own.caught > own.mistakes || (own.fails_reference && own.caught > 0)) {
    throw std::runtime_error("the result of the student's own tests is impossible");
  }
  return own;
}

Json json_of(const std::vector<ChallengeResult>& challenge) {
  Json rows = Json::array();
  for (const ChallengeResult& one : challenge) {
    rows.push_back({{"what", one.what},
                    {"better", one.fewer_is_better ? "fewer" : "more"},
                    {"count", one.count}});
  }
  return rows;
}

/// Of a lab's record or of the judge's result. Most have none.
std::vector<ChallengeResult> challenge_of(const Json& lab) {
  std::vector<ChallengeResult> challenge;
  for (const Json& row : lab.value("challenge", Json::array())) {
    challenge.push_back({row.at("what"), row.at("better") == "fewer", row.at("count")});
  }
  return challenge;
}

Json json_of(const LabRecord& lab) {
  Json tests = Json::array();
  for (const TestResult& test : lab.tests) tests.push_back(json_of(test));
  Json json{
      {"lab", lab.lab},
      {"points", lab.points()},
      {"earned", lab.earned()},
      {"submitted", lab.submitted},
      {"hash", lab.hash},
      {"files", lab.files},
      {"supplied", lab.supplied},
      {"isolation", lab.isolation},
      {"compiler", lab.compiler},
      {"seed", lab.seed},
      {"compile",
       {{"ok", lab.compiled}, {"seconds", lab.compile_seconds}, {"errors", lab.compile_errors}}},
      {"not_graded", lab.not_graded},
      {"tests", tests}};
  if (!lab.same_as.empty()) json["same_as"] = lab.same_as;
  if (lab.own_tests) json["own_tests"] = json_of(*lab.own_tests);
  if (!lab.challenge.empty()) json["challenge"] = json_of(lab.challenge);
  return json;
}

LabRecord lab_of(const Json& json) {
  LabRecord lab;
  lab.lab = json.at("lab");
  lab.submitted = json.at("submitted");
  lab.hash = json.at("hash");
  lab.files = json.at("files");
  lab.supplied = json.at("supplied");
  lab.isolation = json.at("isolation");
  lab.compiler = json.at("compiler");
  lab.seed = json.at("seed");
  lab.compiled = json.at("compile").at("ok");
  lab.compile_seconds = json.at("compile").at("seconds");
  lab.compile_errors = json.at("compile").at("errors");
  lab.not_graded = json.at("not_graded");
  lab.tests = tests_of(json);
  lab.same_as = json.value("same_as", "");
  if (json.contains("own_tests")) lab.own_tests = own_tests_of(json.at("own_tests"));
  lab.challenge = challenge_of(json);
  return lab;
}

std::string written(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Calls `read` with the parsed text; what is wrong with it is reported with the file's name.
template <typename Read>
auto parsed(const std::string& text, const std::string& file, const Read& read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& error) {
    throw std::runtime_error(file + " is damaged: " + error.what());
  }
}

}  // namespace

std::string to_json(const LabRecord& lab) { return written(json_of(lab)); }

std::string to_json(const Record& record) {
  Json labs = Json::array();
  for (const LabRecord& lab : record.labs) labs.push_back(json_of(lab));
  Json ignored = Json::array();
  for (const IgnoredFile& file : record.ignored) {
    ignored.push_back({{"path", file.path}, {"reason", file.reason}, {"files", file.files}});
  }
  Json json{{"format", format},
            {"name", record.name},
            {"source", record.source},
            {"path", record.path},
            {"folders", record.folders},
            {"student", record.student},
            {"identified", record.is_identified},
            {"claimed", {{"student", record.claimed_student}, {"date", record.claimed_date}}},
            {"starter", record.starter},
            {"file_time", record.file_time ? Json(*record.file_time) : Json()},
            {"hash", record.hash},
            {"project", record.project},
            {"trouble", record.trouble},
            {"ignored", ignored},
            {"labs", labs}};
  if (record.engine) json["engine"] = json_of(*record.engine);
  return written(json);
}

LabRecord lab_from_json(const std::string& text, const std::string& file) {
  return parsed(text, file, lab_of);
}

Record record_from_json(const std::string& text, const std::string& file) {
  return parsed(text, file, [&file](const Json& json) {
    if (json.at("format") != format) {
      throw std::runtime_error(file + " has another format than this version writes");
    }
    Record record;
    record.name = json.at("name");
    record.source = json.at("source");
    record.path = json.value("path", "");
    record.folders = json.value("folders", std::vector<std::string>());
    record.student = json.at("student");
    record.is_identified = json.value("identified", false);
    record.claimed_student = json.at("claimed").at("student");
    record.claimed_date = json.at("claimed").at("date");
    record.starter = json.at("starter");
    if (const Json& time = json.at("file_time"); !time.is_null())
      record.file_time = time.get<long>();
    record.hash = json.at("hash");
    record.project = json.at("project");
    record.trouble = json.at("trouble");
    for (const Json& entry : json.at("ignored")) {
      record.ignored.push_back({entry.at("path"), entry.at("reason"), entry.at("files")});
    }
    for (const Json& lab : json.at("labs")) record.labs.push_back(lab_of(lab));
    if (json.contains("engine")) record.engine = lab_of(json.at("engine"));
    return record;
  });
}

OwnTests own_tests_from_judge(const std::string& text, const std::string& file) {
  return parsed(text, file, own_tests_of);
}

LabRecord lab_from_judge(const std::string& text, const std::string& file) {
  constexpr std::size_t longest_errors = 4096;
  return parsed(text, file, [](const Json& json) {
    LabRecord lab;
    lab.lab = json.at("lab");
    lab.isolation = json.at("isolation");
    lab.compiler = json.at("compiler");
    lab.seed = json.at("seed");
    lab.compiled = json.at("compile").at("ok");
    lab.compile_seconds = json.at("compile").at("seconds");
    lab.compile_errors =
        shortened(json.at("compile").at("errors").get<std::string>(), longest_errors);
    lab.tests = tests_of(json);
    lab.challenge = challenge_of(json);
    return lab;
  });
}

}  // namespace cs550::gradebook
