#include "cli/handout/handout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "cli/handout/formula_text.hpp"
#include "cli/system/files.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "cli/verb.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

/// Joins the lines of each paragraph; breaks between paragraphs and before list items stay.
std::string reflowed(const std::string& text) {
  static const std::regex outer("^\\s+|\\s+$");
  static const std::regex break_in_paragraph(R"(([^\n])\n(?!\n|[-*] |[|]|```|[$][$]|[0-9][.]))");
  return std::regex_replace(std::regex_replace(text, outer, ""), break_in_paragraph, "$1 ");
}

/// Reads line by line: a heading opens a step, <details> a hint of the last step.
class Reader {
 public:
  void read(const std::string& line) {
    static const std::regex heading(R"(## (L[0-9]+\.[0-9]+) (.+))");
    static const std::regex opening(R"(<details><summary>(?:Hint [0-9]+: )?(.*)</summary>)");
    std::smatch match;
    if (std::regex_match(line, match, heading)) {
      steps.push_back({match[1], match[2], {}});
    } else if (!steps.empty() && std::regex_match(line, match, opening)) {
      steps.back().hints.push_back({match[1], ""});
      in_hint_ = true;
    } else if (line == "</details>" || line.rfind("## ", 0) == 0) {
      in_hint_ = false;
    } else if (in_hint_) {
      steps.back().hints.back().answer += line + '\n';
    }
  }

  std::vector<Step> steps;

 private:
  bool in_hint_ = false;
};

fs::path shown_hints_file() { return project_root() / "build/results/hints.json"; }

/// How many hints of each step were printed; none if the file is damaged.
Json shown_hints() {
  std::ifstream stream(shown_hints_file());
  const Json json = stream ? Json::parse(stream, nullptr, false) : Json::object();
  return json.is_object() ? json : Json::object();
}

}  // namespace

std::vector<Step> handout_steps(const std::string& lab_name) {
  const fs::path file = project_root() / "labs" / lab_name / "README.md";
  if (!fs::exists(file)) return {};
  std::istringstream lines(read_text(file));
  Reader reader;
  for (std::string line; std::getline(lines, line);) reader.read(line);
  for (Step& step : reader.steps) {
    for (Hint& hint : step.hints) hint.answer = with_plain_formulas(reflowed(hint.answer));
  }
  return reader.steps;
}

Step handout_step(const std::string& lab_name, const std::string& tag) {
  const std::vector<Step> steps = handout_steps(lab_name);
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.tag == tag; });
  return found == steps.end() ? Step{tag, "", {}} : *found;
}

int show_hint(const std::string& lab_name, const std::string& tag, int number) {
  const Step step = handout_step(lab_name, tag);
  const int count = static_cast<int>(step.hints.size());
  if (count == 0 || number > count) {
    std::cerr << fmt::format("cs550: labs/{}/README.md has {} hints for {}; you asked for {}\n",
                             lab_name, count, tag, number > 0 ? number : 1);
    return Misused;
  }
  Json shown = shown_hints();
  const int wanted = number > 0 ? number : std::min(shown.value(tag, 0) + 1, count);
  shown[tag] = wanted;
  files::write_file(shown_hints_file(), shown.dump(2) + '\n');
  const Hint& hint = step.hints[wanted - 1];
  std::cout << coloured(tag + ' ' + step.title, Colour::Bold)
            << fmt::format(", hint {} of {}\n\n", wanted, count) << indented(hint.question, 2)
            << '\n'
            << indented(hint.answer, 2) << '\n'
            << (wanted < count ? "Repeat the command for the next hint.\n"
                               : "This was the last hint of the step.\n");
  return Good;
}

}  // namespace cs550::cli
