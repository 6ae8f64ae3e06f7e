#include "benchmarks/engines/engine.hpp"
#include "benchmarks/engines/peers.hpp"

namespace cs550::bench {

std::vector<Engine> peer_engines() {
  std::vector<Engine> engines;
#if CS550_HAS_BULLET
  add_bullet(engines);
#endif
#if CS550_HAS_ODE
  add_ode(engines);
#endif
  return engines;
}

}  // namespace cs550::bench
