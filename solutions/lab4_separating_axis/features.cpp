#include "features.hpp"

#include <algorithm>
#include <cmath>

namespace cs550::lab4 {

SeparatingAxis with_feature(AxisFeature feature, SeparatingAxis queries, const PosedShape& a,
                            const PosedShape& b) {
  queries.feature = feature;
  switch (feature) {
    case AxisFeature::FaceA:
      queries.axis = a.plane(queries.face_a.face).normal;
      queries.separation = queries.face_a.separation;
      break;
    case AxisFeature::FaceB:
      queries.axis = -b.plane(queries.face_b.face).normal;
      queries.separation = queries.face_b.separation;
      break;
    case AxisFeature::Edges:
      queries.axis = queries.edges.axis;
      queries.separation = queries.edges.separation;
      break;
    case AxisFeature::None:
      break;
  }
  return queries;
}

AxisFeature best_feature(const SeparatingAxis& queries, AxisFeature last, Real tolerance) {
  struct Candidate {
    AxisFeature feature;
    Real separation;
  };
  const Candidate candidates[] = {
      {AxisFeature::FaceA, queries.face_a.separation},
      {AxisFeature::FaceB, queries.face_b.separation},
      {AxisFeature::Edges, queries.edges ? queries.edges.separation : -HUGE_VALF}};

  Real largest = -HUGE_VALF;
  for (const Candidate& candidate : candidates) largest = std::max(largest, candidate.separation);

  AxisFeature best = AxisFeature::None;
  for (const Candidate& candidate : candidates) {
    const bool tied = candidate.separation >= largest - tolerance;
    if (tied && (best == AxisFeature::None || candidate.feature == last)) best = candidate.feature;
  }
  return best;
}

}  // namespace cs550::lab4
