#pragma once
/// @file features.hpp
/// Which of the queries is the answer. In a namespace of the lab's own: what it defines in cs550 itself
/// is what students have to write.

#include "cs550/separating_axis.hpp"

namespace cs550::lab4 {

/// Makes one of the queries the answer.
SeparatingAxis with_feature(AxisFeature feature, SeparatingAxis queries, const PosedShape& a,
                            const PosedShape& b);

/// The feature of largest separation; among those within the tolerance of it last step's kind, then
/// the order A's faces, B's faces, edges.
AxisFeature best_feature(const SeparatingAxis& queries, AxisFeature last, Real tolerance);

}  // namespace cs550::lab4
