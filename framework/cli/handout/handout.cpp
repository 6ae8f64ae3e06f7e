#include "cli/handout/handout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "cli/handout/formula_text.hpp"
#include "cli/system/exit_code.hpp"
#include "cli/system/files.hpp"
#include "cli/system/project.hpp"
#include "cli/system/terminal.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// Whether a line cannot continue the paragraph before it: an empty one, a list item, a row of a
/// table, code or a displayed formula.
bool starts_block(std::string_view text) {
  for (const std::string_view start : {"\n", "- ", "* ", "|", "```", "$$"}) {
    if (text.rfind(start, 0) == 0) return true;
  }
  return text.size() > 1 && is_digit(text[0]) && text[1] == '.';
}

/// Joins the lines of each paragraph; breaks between paragraphs and before list items stay.
std::string reflowed(const std::string& text) {
  constexpr const char* blank = " \n\t";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  std::string result = text.substr(first, text.find_last_not_of(blank) + 1 - first);
  for (std::size_t at = 1; at < result.size(); ++at) {
    const bool ends_a_line = result[at] == '\n' && result[at - 1] != '\n';
    if (ends_a_line && !starts_block(std::string_view(result).substr(at + 1))) result[at] = ' ';
  }
  return result;
}

/// Reads line by line: a heading opens a step, <details> a hint of the last step.
class Reader {
 public:
  void read(const std::string& line) {
    if (line.rfind("## ", 0) == 0) {
      open_step(line.substr(3));
      in_hint_ = false;
    } else if (!steps.empty() && line.rfind(hint_mark, 0) == 0) {
      steps.back().hints.push_back({question(line), ""});
      in_hint_ = true;
    } else if (line == "</details>") {
      in_hint_ = false;
    } else if (in_hint_) {
      steps.back().hints.back().answer += line + '\n';
    }
  }

  std::vector<Step> steps;

 private:
  static constexpr std::string_view hint_mark = "<details><summary>";

  /// "L3.2 Climb the hill" opens a step; other headings do not.
  void open_step(const std::string& heading) {
    const std::size_t space = heading.find(' ');
    const bool is_step = heading.size() > 1 && heading[0] == 'L' && is_digit(heading[1]);
    if (is_step && space != std::string::npos) {
      steps.push_back({heading.substr(0, space), heading.substr(space + 1), {}});
    }
  }

  /// "<details><summary>Hint 1: What moves?</summary>" asks "What moves?".
  static std::string question(const std::string& line) {
    std::string text = line.substr(hint_mark.size());
    text = text.substr(0, text.find("</summary>"));
    const std::size_t colon = text.find(": ");
    const bool is_numbered = text.rfind("Hint ", 0) == 0 && colon != std::string::npos;
    return is_numbered ? text.substr(colon + 2) : text;
  }

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

std::vector<std::string> writing_order(const std::string& lab_name) {
  constexpr std::string_view mark = "- **Order:** ";
  std::ifstream handout(project_root() / "labs" / lab_name / "README.md");
  std::vector<std::string> order;
  for (std::string line; order.empty() && std::getline(handout, line);) {
    if (line.rfind(mark, 0) != 0) continue;
    std::istringstream list(line.substr(mark.size(), line.find(". ") - mark.size()));
    for (std::string tag; list >> tag;) order.push_back(tag.substr(0, tag.find(',')));
  }
  return order;
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
