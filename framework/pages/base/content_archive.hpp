#pragma once
/// @file content_archive.hpp
/// Archives the content of a page with cereal. As in contract_archive.hpp, a new member that is not
/// archived does not compile.

#include <cereal/types/memory.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>

#include "pages/base/content.hpp"
#include "serialisation/contract_archive.hpp"

namespace cs550::drawing {

template <class Archive>
void serialize(Archive& archive, Point& point) {
  auto& [position, role, radius] = point;
  archive(position, role, radius);
}

template <class Archive>
void serialize(Archive& archive, Stroke& stroke) {
  auto& [role, width, dashed, arrow] = stroke;
  archive(role, width, dashed, arrow);
}

template <class Archive>
void serialize(Archive& archive, Line& line) {
  auto& [from, to, stroke] = line;
  archive(from, to, stroke);
}

template <class Archive>
void serialize(Archive& archive, Polygon& polygon) {
  auto& [corners, role, opacity] = polygon;
  archive(corners, role, opacity);
}

template <class Archive>
void serialize(Archive& archive, Ball& ball) {
  auto& [center, radius, role, opacity] = ball;
  archive(center, radius, role, opacity);
}

template <class Archive>
void serialize(Archive& archive, Label& label) {
  auto& [position, text, role] = label;
  archive(position, text, role);
}

template <class Archive>
void serialize(Archive& archive, LegendEntry& entry) {
  auto& [text, stroke, mark] = entry;
  archive(text, stroke, mark);
}

template <class Archive>
void serialize(Archive& archive, Drawing& drawing) {
  auto& [title, alt_text, points, lines, polygons, balls, labels, legend, notes] = drawing;
  archive(title, alt_text, points, lines, polygons, balls, labels, legend, notes);
}

template <class Archive>
void serialize(Archive& archive, Series& series) {
  auto& [name, values, style, role, dashed] = series;
  archive(name, values, style, role, dashed);
}

template <class Archive>
void serialize(Archive& archive, PlotMark& mark) {
  auto& [at, vertical, text, role] = mark;
  archive(at, vertical, text, role);
}

template <class Archive>
void serialize(Archive& archive, Plot& plot) {
  auto& [title, alt_text, x_label, y_label, logarithmic, logarithmic_x, series, marks, notes] =
      plot;
  archive(title, alt_text, x_label, y_label, logarithmic, logarithmic_x, series, marks, notes);
}

}  // namespace cs550::drawing

namespace cs550::pages {

template <class Archive>
void serialize(Archive& archive, Focus& focus) {
  auto& [center, radius] = focus;
  archive(center, radius);
}

template <class Archive>
void serialize(Archive& archive, Solid& solid) {
  auto& [mesh, pose, colour, is_ground] = solid;
  archive(mesh, pose, colour, is_ground);
}

template <class Archive>
void serialize(Archive& archive, Fact& fact) {
  auto& [name, value] = fact;
  archive(name, value);
}

template <class Archive>
void serialize(Archive& archive, Content& content) {
  auto& [solids, drawing, plots, facts, step_count, focus, problem, lost] = content;
  archive(solids, drawing, plots, facts, step_count, focus, problem, lost);
}

}  // namespace cs550::pages
