#pragma once
/// @file replaced.hpp
/// The function of the reference that has a faster form here. Where objects are linked (link-time
/// optimisation) the reference is compiled with this header, and its definition is weak.

#include "cs550/clipping.hpp"

namespace cs550 {

[[gnu::weak]] Manifold face_manifold(const PosedShape& a, const PosedShape& b,
                                     const SeparatingAxis& axis, Real margin);

}  // namespace cs550
