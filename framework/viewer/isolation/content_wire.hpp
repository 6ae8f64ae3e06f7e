#pragma once
/// @file content_wire.hpp
/// How a page's content travels.

#include "viewer/content.hpp"
#include "viewer/isolation/wire.hpp"

namespace cs550::viewer {

CS550_PLAIN(Vec2);
CS550_PLAIN(Vec3);
CS550_PLAIN(Pose);
CS550_PLAIN(Bounds);
CS550_PLAIN(HalfEdge);
CS550_PLAIN(Face);
CS550_PLAIN(Rgba);
CS550_PLAIN(Focus);
CS550_PLAIN(drawing::Stroke);
CS550_PLAIN(drawing::Point);
CS550_PLAIN(drawing::Line);
CS550_PLAIN(drawing::Ball);

template <class Archive, class Value>
void serialize(Archive& archive, Answer<Value>& answer) {
  archive(answer.value, answer.failure);
}

template <class Archive>
void serialize(Archive& archive, Solid& solid) {
  archive(solid.mesh, solid.pose, solid.colour, solid.is_ground);
}

template <class Archive>
void serialize(Archive& archive, Fact& fact) {
  archive(fact.name, fact.value);
}

template <class Archive>
void serialize(Archive& archive, Content& content) {
  archive(content.solids, content.drawing, content.plots, content.facts, content.step_count,
          content.focus, content.problem);
}

}  // namespace cs550::viewer

namespace cs550 {

template <class Archive>
void serialize(Archive& archive, HalfEdgeMesh& mesh) {
  archive(mesh.vertices, mesh.vertex_edge, mesh.edges, mesh.faces);
}

}  // namespace cs550

namespace cs550::drawing {

template <class Archive>
void serialize(Archive& archive, Polygon& polygon) {
  archive(polygon.corners, polygon.role, polygon.opacity);
}
template <class Archive>
void serialize(Archive& archive, Label& label) {
  archive(label.position, label.text, label.role);
}
template <class Archive>
void serialize(Archive& archive, LegendEntry& entry) {
  archive(entry.text, entry.stroke, entry.mark);
}
template <class Archive>
void serialize(Archive& archive, Drawing& drawing) {
  archive(drawing.title, drawing.alt_text, drawing.points, drawing.lines, drawing.polygons,
          drawing.balls, drawing.labels, drawing.legend, drawing.notes);
}
template <class Archive>
void serialize(Archive& archive, Series& series) {
  archive(series.name, series.values, series.style, series.role, series.dashed);
}
template <class Archive>
void serialize(Archive& archive, PlotMark& mark) {
  archive(mark.at, mark.vertical, mark.text, mark.role);
}
template <class Archive>
void serialize(Archive& archive, Plot& plot) {
  archive(plot.title, plot.alt_text, plot.x_label, plot.y_label, plot.logarithmic, plot.series,
          plot.marks, plot.notes);
}

}  // namespace cs550::drawing
