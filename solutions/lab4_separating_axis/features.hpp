#pragma once
/// @file features.hpp
/// Which of the queries is the answer. Not in namespace cs550: what a lab defines there is what
/// students have to write.

#include "cs550/separating_axis.hpp"

namespace lab4 {

/// Makes one of the queries the answer.
cs550::SeparatingAxis with_feature(cs550::AxisFeature feature, cs550::SeparatingAxis queries,
                                   const cs550::PosedShape& a, const cs550::PosedShape& b);

/// The feature of largest separation; among those within the tolerance of it last step's kind, then
/// the order A's faces, B's faces, edges.
cs550::AxisFeature best_feature(const cs550::SeparatingAxis& queries, cs550::AxisFeature last,
                                cs550::Real tolerance);

}  // namespace lab4
