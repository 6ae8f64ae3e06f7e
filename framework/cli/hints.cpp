#include "hints.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "handout.hpp"
#include "lab_files.hpp"
#include "project.hpp"
#include "terminal.hpp"
#include "verb.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

fs::path memory() { return project_root() / "build/results/hints.json"; }

/// How many hints of each step were shown. A damaged file is an empty one: only hints are lost.
Json hints_shown() {
  std::ifstream stream(memory());
  const Json json = stream ? Json::parse(stream, nullptr, false) : Json::object();
  return json.is_object() ? json : Json::object();
}

void remember_hint(const std::string& tag, int number) {
  Json shown = hints_shown();
  shown[tag] = number;
  fs::create_directories(memory().parent_path());
  write_text(memory(), shown.dump(2) + '\n');
}

}  // namespace

int show_hint(const std::string& lab_name, const std::string& tag, int number) {
  const Step step = handout_step(lab_name, tag);
  const int count = static_cast<int>(step.hints.size());
  if (count == 0 || number > count) {
    std::cerr << "cs550: the handout of " << lab_name << " has "
              << (count == 0 ? "no hints" : "only " + std::to_string(count) + " hints") << " for "
              << tag << ".\n";
    return Misused;
  }
  const int wanted = number > 0 ? number : std::min(hints_shown().value(tag, 0) + 1, count);
  remember_hint(tag, wanted);
  const Hint& hint = step.hints[static_cast<std::size_t>(wanted - 1)];
  std::cout << coloured(tag + ' ' + step.title, Colour::Bold) << ", hint " << wanted << " of "
            << count << "\n\n"
            << indented(hint.question, 2) << '\n'
            << indented(hint.answer, 2) << '\n'
            << (wanted < count ? "Ask again for the next one.\n" : "That was the last hint.\n");
  return Good;
}

}  // namespace cs550::cli
