#include "dynamics/kappas.h"

#include <limits>

namespace tricontact::dynamics {

double critical_friction(const Kappas& kappas) {
    const double lever = kappas.kappa3 * (1 + kappas.kappa8);  // (h + a)/b
    return lever > 0 ? 1 / lever : std::numeric_limits<double>::infinity();
}

double tilting_limit(const Kappas& kappas) {
    return 0.1 * kappas.kappa3;  // phi = (a/b) Phi
}

}  // namespace tricontact::dynamics
