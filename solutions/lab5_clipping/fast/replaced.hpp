#pragma once
/// @file replaced.hpp
/// The functions of the reference that have a faster form here. Where objects are linked (link-time
/// optimisation) the reference is compiled with this header, and its definitions are weak.

#include "cs550/clipping.hpp"

namespace cs550 {

[[gnu::weak]] Index find_incident_face(const PosedShape& body, const Vec3& reference_normal);
[[gnu::weak]] Manifold face_manifold(const PosedShape& a, const PosedShape& b,
                                     const SeparatingAxis& axis, Real margin);

}  // namespace cs550
