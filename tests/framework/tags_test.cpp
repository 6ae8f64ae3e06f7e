/// A step's tag, such as L3.2, occurs in handout, header, starter, tests, points and mutants. All
/// must agree on the steps.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Names = std::set<std::string>;

const fs::path root = fs::path(CS550_TEST_DATA).parent_path().parent_path();

std::string read(const fs::path& file) {
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << "cannot read " << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

Json read_json(const fs::path& file) { return Json::parse(read(file), nullptr, false); }

/// All matches of the first group of a pattern in a text.
std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

Names as_set(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

/// The names of a lab.
struct Lab {
  std::string folder;  ///< "lab3_hill_climbing"

  std::string number() const { return folder.substr(3, folder.find('_') - 3); }
  std::string topic() const { return folder.substr(folder.find('_') + 1); }

  fs::path header() const { return root / "framework/include/cs550" / (topic() + ".hpp"); }
  /// The starters as handed out, because students may edit the comments.
  std::string starter() const {
    const fs::path pristine = root / ".starters" / folder;
    std::string text;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::exists(pristine) ? pristine : root / "labs" / folder)) {
      if (entry.path().extension() == ".cpp") text += read(entry.path());
    }
    return text;
  }
  fs::path handout() const { return root / "labs" / folder / "README.md"; }
  fs::path manifest() const { return root / "tests" / folder / "manifest.json"; }
  fs::path mutants() const { return root / "tests/mutants" / ("lab" + number() + ".json"); }

  /// The tags of this lab's steps that occur in a text.
  Names tags(const std::string& text) const {
    return as_set(all_matches(text, R"(\b(L)" + number() + R"(\.\d+)\b)"));
  }
};

void PrintTo(const Lab& lab, std::ostream* out) { *out << lab.folder; }

/// The handout's sections `## L3.2 Title`, by tag.
std::map<std::string, std::string> sections(const Lab& lab) {
  std::map<std::string, std::string> found;
  const std::string text = "\n" + read(lab.handout());
  std::size_t heading = text.find("\n## ");
  while (heading != std::string::npos) {
    const std::size_t next = text.find("\n## ", heading + 1);
    const std::string section = text.substr(heading, next - heading);
    std::smatch tag;
    if (std::regex_search(section, tag, std::regex(R"(^\n## (L\d+\.\d+) \S)"))) {
      found[tag[1]] = section;
    }
    heading = next;
  }
  return found;
}

/// The visible tests of a step, as the handout lists them.
struct Checks {
  int points = 0;
  Names tests;

  bool operator==(const Checks& other) const {
    return points == other.points && tests == other.tests;
  }
};

void PrintTo(const Checks& checks, std::ostream* out) {
  *out << checks.points << " points:";
  for (const std::string& test : checks.tests) *out << ' ' << test;
}

std::map<std::string, Checks> visible_checks(const Json& manifest) {
  std::map<std::string, Checks> steps;
  for (const Json& test : manifest.at("tests")) {
    if (test.at("hidden")) continue;
    Checks& step = steps[test.at("step")];
    step.points += test.at("points").get<int>();
    step.tests.insert(test.at("name"));
  }
  return steps;
}

Names visible_tests(const Lab& lab) {
  Names tests;
  for (const auto& [tag, checks] : visible_checks(read_json(lab.manifest()))) {
    tests.insert(checks.tests.begin(), checks.tests.end());
  }
  return tests;
}

/// From "**10 points.** Checked by `One`,\n`Two`."
Checks stated_checks(const std::string& section) {
  std::smatch match;
  if (!std::regex_search(section, match,
                         std::regex(R"(\*\*(\d+) points?\.\*\* Checked by ([^.]*)\.)"))) {
    return {};
  }
  return {std::stoi(match[1]), as_set(all_matches(match[2], "`(\\w+)`"))};
}

class Tags : public testing::TestWithParam<Lab> {
 protected:
  const Lab& lab = GetParam();
};

TEST_P(Tags, HeaderStarterHandoutAndTestsKnowTheSameSteps) {
  Names handout;
  for (const auto& [tag, section] : sections(lab)) handout.insert(tag);
  ASSERT_FALSE(handout.empty()) << lab.handout();
  EXPECT_EQ(lab.tags(read(lab.header())), handout) << lab.header();
  EXPECT_EQ(lab.tags(lab.starter()), handout) << "the starter in labs/" << lab.folder;
  EXPECT_EQ(lab.tags(read(lab.handout())), handout) << "the handout names a step without a section";

  const Json manifest = read_json(lab.manifest());
  ASSERT_FALSE(manifest.is_discarded()) << lab.manifest();
  Names graded;
  for (const auto& [tag, checks] : visible_checks(manifest)) graded.insert(tag);
  EXPECT_EQ(graded, handout) << "every step has a visible test";
}

TEST_P(Tags, HandoutStatesThePointsAndTestsOfEachStep) {
  const Json manifest = read_json(lab.manifest());
  ASSERT_FALSE(manifest.is_discarded()) << lab.manifest();
  std::map<std::string, Checks> steps = visible_checks(manifest);
  for (const auto& [tag, section] : sections(lab)) {
    EXPECT_EQ(stated_checks(section), steps[tag]) << tag;
  }
}

TEST_P(Tags, EveryStepHasThreeHints) {
  const std::string hint = R"(<details>\s*<summary>([^<]*)</summary>)";
  for (const auto& [tag, section] : sections(lab)) {
    const std::vector<std::string> questions = all_matches(section, hint);
    EXPECT_EQ(questions.size(), 3U) << tag;
    for (const std::string& question : questions) {
      EXPECT_TRUE(std::regex_match(question, std::regex(R"(Hint \d: .*\?)")))
          << tag << ": " << question;
    }
    for (const std::string& body : all_matches(section, "</summary>([^]*?)</details>")) {
      EXPECT_TRUE(std::regex_search(body, std::regex(R"(\w)"))) << tag << ": an empty hint";
    }
  }
}

/// The mutants of labN.json, with those for which a test never ends.
Json all_mutants(const Json& document) {
  Json mutants = document.at("mutants");
  for (const Json& mutant : document.value("endless", Json::array())) mutants.push_back(mutant);
  return mutants;
}

TEST_P(Tags, MutantsBreakStepsThatExist) {
  if (!fs::exists(lab.mutants())) GTEST_SKIP() << "the students' copy has no mutants";
  const Json document = read_json(lab.mutants());
  ASSERT_FALSE(document.is_discarded()) << lab.mutants();
  EXPECT_EQ(document.at("lab"), std::stoi(lab.number()));
  const std::map<std::string, std::string> steps = sections(lab);
  Names names;
  for (const Json& mutant : all_mutants(document)) {
    const std::string name = mutant.at("name");
    EXPECT_TRUE(names.insert(name).second) << name << " occurs twice";
    EXPECT_TRUE(steps.count(mutant.at("step"))) << name;
    EXPECT_FALSE(mutant.at("names_cause").get<std::string>().empty()) << name;
    for (const std::string step : mutant.at("may_also_fail")) {
      EXPECT_TRUE(steps.count(step)) << name << ": " << step;
    }
  }
}

/// The steps that a list of labN.json names.
Names named_steps(const Json& list) {
  Names steps;
  for (const Json& entry : list) steps.insert(entry.at("step").get<std::string>());
  return steps;
}

TEST_P(Tags, EveryStepHasAMutantAVacuousAnswerAndAPlaceInTheOrder) {
  if (!fs::exists(lab.mutants())) GTEST_SKIP() << "the students' copy has no mutants";
  const Json document = read_json(lab.mutants());
  ASSERT_FALSE(document.is_discarded()) << lab.mutants();
  Names steps;
  for (const auto& [tag, section] : sections(lab)) steps.insert(tag);
  for (const char* list : {"mutants", "vacuous", "order"}) {
    EXPECT_EQ(named_steps(document.at(list)), steps) << list;
  }
  EXPECT_EQ(document.at("order").size(), steps.size()) << "each step once";
}

TEST_P(Tags, AnEndlessMistakeIsPrepared) {
  if (!fs::exists(lab.mutants())) GTEST_SKIP() << "the students' copy has no mutants";
  const Json document = read_json(lab.mutants());
  ASSERT_FALSE(document.is_discarded()) << lab.mutants();
  EXPECT_FALSE(document.value("endless", Json::array()).empty())
      << "a test that was stopped would print no cause: " << lab.mutants();
}

/// From "- **Order:** L1.1, L1.3. ...": the steps in that order.
std::vector<std::string> stated_order(const std::string& handout) {
  std::smatch match;
  if (!std::regex_search(handout, match, std::regex(R"(\n- \*\*Order:\*\* ([L\d., ]*)\. )")))
    return {};
  return all_matches(match[1], R"((L\d+\.\d+))");
}

TEST_P(Tags, TheHandoutStatesTheOrderThatIsChecked) {
  if (!fs::exists(lab.mutants())) GTEST_SKIP() << "the students' copy has no mutants";
  const Json document = read_json(lab.mutants());
  ASSERT_FALSE(document.is_discarded()) << lab.mutants();
  std::vector<std::string> checked;  // by tests/mutants/check_order.py
  for (const Json& step : document.at("order")) checked.push_back(step.at("step"));
  EXPECT_EQ(stated_order(read(lab.handout())), checked) << lab.handout();
}

TEST_P(Tags, RecordedEarlierLabsAreThoseOfVisibleTests) {
  const Names tests = visible_tests(lab);
  const Json document = read_json(root / "tests" / lab.folder / "earlier_labs.json");
  ASSERT_FALSE(document.is_discarded()) << "tests/mutants/record_earlier_labs.py --record";
  for (const auto& [test, earlier] : document.get<std::map<std::string, std::vector<int>>>()) {
    EXPECT_TRUE(tests.count(test)) << test;
    for (const int number : earlier) EXPECT_LT(number, std::stoi(lab.number())) << test;
  }
}

TEST_P(Tags, RecordedCausesNameVisibleTestsAndMutants) {
  const fs::path file = root / "tests" / lab.folder / "causes.json";
  if (!fs::exists(file)) GTEST_SKIP() << "no causes are recorded for this lab";
  const Names tests = visible_tests(lab);
  Names causes;
  if (fs::exists(lab.mutants())) {
    const Json document = read_json(lab.mutants());
    for (const Json& mutant : all_mutants(document)) {
      causes.insert(mutant.at("names_cause").get<std::string>());
    }
  }
  const auto recorded = read_json(file).get<std::map<std::string, std::map<std::string, Names>>>();
  ASSERT_FALSE(recorded.empty()) << file;
  for (const auto& [cause, failing] : recorded) {
    if (!causes.empty()) {
      EXPECT_TRUE(causes.count(cause)) << cause;
    }
    EXPECT_FALSE(failing.at("step").empty()) << cause;
    for (const char* where : {"step", "elsewhere"}) {
      for (const std::string& test : failing.at(where)) {
        EXPECT_TRUE(tests.count(test)) << cause << ": " << test;
      }
    }
    const auto endless = failing.find("endless");
    if (endless == failing.end()) continue;
    for (const std::string& test : endless->second) {
      EXPECT_TRUE(tests.count(test)) << cause << ": " << test;
    }
  }
}

std::vector<Lab> labs() {
  std::vector<Lab> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "labs")) {
    if (entry.is_directory()) found.push_back({entry.path().filename()});
  }
  return found;
}

INSTANTIATE_TEST_SUITE_P(Labs, Tags, testing::ValuesIn(labs()),
                         [](const auto& test) { return test.param.folder; });

}  // namespace
