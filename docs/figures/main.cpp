/// @file main.cpp
/// book_figures: draws the pictures of the book and measures its tables.
///
///   book_figures --figures DIR --data DIR [--only NAME]
///   book_figures --live DESCRIPTION --output FILE
///   book_figures --hulls CLOUDS --output FILE

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "benchmark_figures.hpp"
#include "cloud_hulls.hpp"
#include "cs550/not_implemented.hpp"
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

/// Where a lab is not written yet, as in a students' copy, its figure says so.
drawing::Page unwritten(const NotImplemented& missing) {
  drawing::Drawing note;
  note.title = "This figure is drawn by your own code.";
  note.notes = {missing.what()};
  drawing::Page page;
  page.panels = {drawing::Scene{note, drawing::view_from_above()}};
  page.panel_size = {640, 60};
  return page;
}

void draw(const Figure& figure, const fs::path& folder) {
  std::ofstream file(folder / (figure.name + ".svg"));
  try {
    file << drawing::write_svg(figure.draw());
  } catch (const NotImplemented& missing) {
    file << drawing::write_svg(unwritten(missing));
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + figure.name);
}

void measure(const Table& table, const fs::path& folder) {
  std::ofstream file(folder / (table.name + ".dat"));
  file.precision(9);
  try {
    table.measure(file);
  } catch (const NotImplemented& missing) {
    file << "# " << missing.what() << "\n0 0 0 0 0 0 0 0\n1 1 1 1 1 1 1 1\n";
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + table.name);
}

void draw_live(const std::string& description, const std::string& name) {
  std::ofstream file(name);
  file << live::LiveFigure(description).svg();
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

}  // namespace
}  // namespace cs550::book

int main(int argc, char** argv) {
  using namespace cs550::book;
  CLI::App app("Draws the pictures of the book and measures its tables.");
  std::string figures, data, only, live, hulls, output;
  app.add_option("--figures", figures, "folder for pictures");
  app.add_option("--data", data, "folder for tables");
  app.add_option("--only", only, "one picture or table");
  app.add_option("--live", live, "a live figure as it is at first: a page's number and settings");
  app.add_option("--hulls", hulls, "point clouds that the browser's engine has listed");
  app.add_option("--output", output, "file for --live and --hulls");
  CLI11_PARSE(app, argc, argv);
  try {
    if (!live.empty()) draw_live(live, output);
    if (!hulls.empty()) answer_clouds(hulls, output);
    for (const Figure& figure : all_figures()) {
      if (!figures.empty() && (only.empty() || only == figure.name)) draw(figure, figures);
    }
    for (const Table& table : all_tables()) {
      if (!data.empty() && (only.empty() || only == table.name)) measure(table, data);
    }
  } catch (const std::exception& error) {
    std::cerr << "book_figures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
