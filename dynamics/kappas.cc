#include "dynamics/kappas.h"

#include <limits>

namespace tricontact::dynamics {

double critical_friction(const Kappas& kappas) {
    const double lever = kappas.kappa3 * (1 + kappas.kappa8);  // (h + a)/b
    return lever > 0 ? 1 / lever : std::numeric_limits<double>::infinity();
}

}  // namespace tricontact::dynamics
