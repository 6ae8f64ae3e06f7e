#include "helpers/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "pages/failure/failure_panels.hpp"

namespace cs550::test {
namespace {

namespace fs = std::filesystem;

std::string name_of(const testing::TestInfo& test) {
  std::string name = std::string(test.test_suite_name()) + '.' + test.name();
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

fs::path folder() {
  const char* chosen = std::getenv("CS550_PICTURES");
  return chosen != nullptr ? chosen : CS550_PICTURES_DIR;
}

/// Writes a temporary file and renames it, so that two concurrent runs of a test do not interfere.
bool write(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const fs::path draft = file.string() + '.' + std::to_string(std::hash<std::string>()(text));
  std::ofstream stream(draft);
  stream << text;
  stream.close();
  if (stream) fs::rename(draft, file, error);
  return stream && !error;
}

bool is_empty(const Bounds& box) { return !(box.lower.array() <= box.upper.array()).all(); }

/// The scenes of a page, framed as in its picture, each with all plots.
std::vector<pages::FailurePanel> panels_of(const drawing::Page& page) {
  std::vector<pages::FailurePanel> panels;
  std::vector<drawing::Plot> plots;
  for (const drawing::Panel& part : page.panels) {
    if (const auto* plot = std::get_if<drawing::Plot>(&part)) {
      plots.push_back(*plot);
      continue;
    }
    const auto& [drawing, view] = std::get<drawing::Scene>(part);
    const Bounds frame = is_empty(view.frame) ? drawing::bounds(drawing) : view.frame;
    pages::FailurePanel& panel = panels.emplace_back();
    panel.content.drawing = drawing;
    panel.toward_eye = view.toward_eye;
    if (page.framed_by_first && panels.size() > 1) {
      panel.content.focus = panels.front().content.focus;
    } else if (!is_empty(frame)) {
      panel.content.focus = pages::focus_of(frame);
    }
  }
  if (panels.empty()) panels.emplace_back();
  for (pages::FailurePanel& panel : panels) panel.content.plots = plots;
  return panels;
}

std::string to_file(const drawing::Page& page) {
  return pages::with_panels(drawing::write_svg(page), panels_of(page));
}

/// The shortest path that a terminal can open.
std::string shown(const fs::path& file) {
  std::error_code error;
  const fs::path near = fs::relative(file, fs::current_path(error), error);
  return error || near.empty() || *near.begin() == ".." ? file.string() : near.string();
}

}  // namespace

std::string write_picture(const std::function<std::string()>& draw) {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr || folder().empty()) return "";
  // A student's code may return any values, and code that reads them may throw.
  try {
    const fs::path file = folder() / (name_of(*test) + ".svg");
    return write(file, draw()) ? shown(file) : "";
  } catch (...) {
    return "";
  }
}

std::string expected_beside_got(const std::string& title, drawing::Drawing expected,
                                drawing::Drawing got, const drawing::View& view,
                                const std::string& note) {
  expected.title = "Expected: " + expected.title;
  got.title = "Got: " + got.title;
  expected.alt_text = "Expected: " + expected.alt_text;
  got.alt_text = "Got: " + got.alt_text;
  drawing::Page page;
  page.title = title;
  page.panels = {drawing::Scene{std::move(expected), view}, drawing::Scene{std::move(got), view}};
  page.framed_by_first = true;
  if (!note.empty()) page.notes.push_back(note);
  return to_file(page);
}

std::string side_by_side(const std::string& title, std::vector<drawing::Panel> panels,
                         const std::string& note) {
  drawing::Page page;
  page.title = title;
  page.panels = std::move(panels);
  if (!note.empty()) page.notes.push_back(note);
  return to_file(page);
}

}  // namespace cs550::test
