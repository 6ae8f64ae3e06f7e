/// @file main.cpp
/// book_figures: draws the pictures of the book and measures its tables.
///
///   book_figures --figures DIR --data DIR [--only NAME]
///   book_figures --live DESCRIPTION --output FILE
///   book_figures --hulls CLOUDS --output FILE
///   book_figures --unwritten REASON --output FILE

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "benchmark_figures.hpp"
#include "cloud_hulls.hpp"
#include "figure.hpp"
#include "live_figure.hpp"

namespace cs550::book {
namespace {

namespace fs = std::filesystem;

template <class Item>
void add(std::vector<Item>& all, std::vector<Item> more) {
  for (Item& item : more) all.push_back(std::move(item));
}

/// What `./cs550 bench` measured when the book was written: measuring takes too long for each build.
std::string recorded_benchmarks() {
  std::ifstream file(CS550_RECORDED_BENCHMARKS);
  if (!file) throw std::runtime_error("cannot read " CS550_RECORDED_BENCHMARKS);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Figure> all_figures() {
  std::vector<Figure> all;
  add(all, conventions_figures());
  add(all, rigid_body_figures());
  add(all, mesh_figures());
  add(all, climbing_figures());
  add(all, gauss_map_figures());
  add(all, axis_figures());
  add(all, contact_figures());
  add(all, solver_figures());
  add(all, mass_figures());
  add(all, benchmark_figures(recorded_benchmarks()));
  return all;
}

std::vector<Table> all_tables() {
  std::vector<Table> all;
  add(all, rigid_body_tables());
  add(all, collision_tables());
  add(all, solver_tables());
  add(all, scene_tables());
  add(all, rebuild_tables());
  return all;
}

constexpr rlim_t most_seconds = 30;  // of processor time for one figure
constexpr const char* never_ends =
    "It crashed, or did not end within 30 s of processor time. See ./cs550 lab N.";

/// Runs a task in a process of its own: a student's function may crash or never end.
/// @return whether it ended @throws std::runtime_error if it threw, after it has printed what
bool ends(const std::function<void()>& task) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    const rlimit limit{most_seconds, most_seconds};
    setrlimit(RLIMIT_CPU, &limit);
    try {
      task();
    } catch (const std::exception& error) {
      std::cerr << "book_figures: " << error.what() << '\n';
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0) throw std::runtime_error("a figure failed");
  return WIFEXITED(status);
}

/// Begins a table that could not be measured. build_book.sh looks for it.
constexpr const char* unwritten_mark = "# unwritten: ";

/// What a figure shows whose lab is not written yet, is wrong or does not end.
drawing::Page unwritten(const std::string& reason) {
  drawing::Drawing note;
  note.title = "This figure is drawn by your own code.";
  note.notes = {reason};
  drawing::Page page;
  page.panels = {drawing::Scene{note, drawing::view_from_above()}};
  page.panel_size = {640, 60};
  return page;
}

/// Writes a file by a task, or by `instead` with the reason why a student's code cannot do it.
void write(const fs::path& path, const std::function<void(std::ostream&)>& task,
           const std::function<void(std::ostream&, const std::string&)>& instead) {
  const auto write_by = [&](const std::function<void(std::ostream&)>& writer) {
    std::ofstream file(path);
    file.precision(9);
    writer(file);
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  };
  const auto explain = [&](const std::string& reason) {
    write_by([&](std::ostream& file) { instead(file, reason); });
  };
  const bool has_ended = ends([&] {
    try {
      write_by(task);
    } catch (const std::exception& error) {
      explain(error.what());
    }
  });
  if (!has_ended) explain(never_ends);
}

void explain_picture(std::ostream& file, const std::string& reason) {
  file << drawing::write_svg(unwritten(reason));
}

void draw(const Figure& figure, const fs::path& folder) {
  const auto picture = [&](std::ostream& file) { file << drawing::write_svg(figure.draw()); };
  write(folder / (figure.name + ".svg"), picture, explain_picture);
}

void measure(const Table& table, const fs::path& folder) {
  write(folder / (table.name + ".dat"), table.measure,
        [](std::ostream& file, const std::string& reason) {
          const std::string first_line = reason.substr(0, reason.find('\n'));
          file << unwritten_mark << first_line << "\n0 0 0 0 0 0 0 0\n1 1 1 1 1 1 1 1\n";
        });
}

void draw_live(const std::string& description, const std::string& name) {
  const auto picture = [&](std::ostream& file) { file << live::LiveFigure(description).svg(); };
  write(name, picture, explain_picture);
}

}  // namespace
}  // namespace cs550::book

int main(int argc, char** argv) {
  using namespace cs550::book;
  CLI::App app("Draws the pictures of the book and measures its tables.");
  std::string figures, data, only, live, hulls, unmeasured, output;
  app.add_option("--figures", figures, "folder for pictures, made if it is not there");
  app.add_option("--data", data, "folder for tables");
  app.add_option("--only", only, "one picture or table, as docs/figures/figures.txt names it");
  app.add_option("--live", live, "a live figure as it is at first: a page's number and settings");
  app.add_option("--hulls", hulls, "point clouds that the browser's engine has listed");
  app.add_option("--unwritten", unmeasured, "why a plot cannot be drawn");
  app.add_option("--output", output, "file for --live, --hulls and --unwritten");
  CLI11_PARSE(app, argc, argv);
  try {
    if (!live.empty()) draw_live(live, output);
    if (!hulls.empty()) answer_clouds(hulls, output);
    if (!unmeasured.empty()) {
      std::ofstream file(output);
      explain_picture(file, unmeasured);
    }
    if (!figures.empty()) fs::create_directories(figures);
    bool is_known = only.empty();
    for (const Figure& figure : all_figures()) {
      is_known = is_known || only == figure.name;
      if (!figures.empty() && (only.empty() || only == figure.name)) draw(figure, figures);
    }
    for (const Table& table : all_tables()) {
      is_known = is_known || only == table.name;
      if (!data.empty() && (only.empty() || only == table.name)) measure(table, data);
    }
    if (!is_known) {
      throw std::runtime_error("no figure or table has the name '" + only +
                               "'; docs/figures/figures.txt lists the figures");
    }
  } catch (const std::exception& error) {
    std::cerr << "book_figures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
