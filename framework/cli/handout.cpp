#include "handout.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "formula_text.hpp"
#include "lab_files.hpp"
#include "project.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;

namespace {

/// Text without the line breaks of its file: those between paragraphs and before list items stay.
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

}  // namespace cs550::cli
