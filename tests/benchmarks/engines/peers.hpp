#pragma once
/// @file peers.hpp
/// The adapters of other engines. Each is in a file of its own, which is compiled only if the
/// engine's package is there.

#include "benchmarks/engines/engine.hpp"

namespace cs550::bench {

void add_bullet(std::vector<Engine>& engines);
void add_ode(std::vector<Engine>& engines);

}  // namespace cs550::bench
