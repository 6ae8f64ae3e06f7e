#pragma once
/// @file replaced.hpp
/// The functions of the reference that have a faster form here. Where objects are linked (link-time
/// optimisation) the reference is compiled with this header, and its definitions are weak.

#include "cs550/separating_axis.hpp"

namespace cs550 {

[[gnu::weak]] FaceQuery query_face_directions(const PosedShape& a, const PosedShape& b);
[[gnu::weak]] EdgeQuery query_edge_directions(const PosedShape& a, const PosedShape& b);
[[gnu::weak]] SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b,
                                                  const SeparatingAxis& hint, Real margin);

}  // namespace cs550
