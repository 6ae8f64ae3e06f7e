#pragma once
/// @file gjk.hpp
/// GJK and EPA as libccd has them, on our hulls: what find_separating_axis() is compared with.

#include <optional>

#include "cs550/convex_shape.hpp"

namespace cs550::bench {

/// Whether two bodies overlap, by the algorithm of Gilbert, Johnson and Keerthi. The support
/// functions are lab 3's climb, which starts at the last answer.
bool gjk_overlap(const PosedShape& a, const PosedShape& b);

/// The penetration depth by GJK and the expanding polytope algorithm (m). Empty if the bodies are
/// apart or the library gives up. Of deep pairs with many vertices some depths are far too small.
std::optional<double> epa_depth(const PosedShape& a, const PosedShape& b);

}  // namespace cs550::bench
