#include "contact/friction/friction_memory.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

double FrictionWeakening::left(double way) const {
    return law == Law::linear ? std::max(0., 1 - way / length) : std::exp(-way / length);
}

double FrictionWeakening::integral(double way) const {
    if (law == Law::exponential) return -length * std::expm1(-way / length);
    const double falling = std::min(way, length);
    return falling * (1 - falling / (2 * length));
}

}  // namespace tricontact::contact
