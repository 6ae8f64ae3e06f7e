#include "cs550/contact_constraint.hpp"

namespace cs550 {

Softness soft_contact(Real hertz, Real damping_ratio, Real h) {
  const Real omega = 2 * pi * hertz;
  const Real a1 = 2 * damping_ratio + h * omega;
  const Real a2 = h * omega * a1;
  const Real a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

}  // namespace cs550
