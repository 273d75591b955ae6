#include "theory/rolling/creep_law.h"

#include <cmath>
#include <stdexcept>

namespace tricontact::theory {

double cubic_force_ratio(double creepage_ratio) {
    if (!(creepage_ratio >= 0))
        throw std::domain_error("creep law: the creepage must not be negative");
    return creepage_ratio < 1 ? 1 - std::pow(1 - creepage_ratio, 3) : 1;
}

double cubic_creepage_ratio(double f) {
    if (!(f >= 0 && f <= 1)) throw std::domain_error("creep law: f must lie between 0 and 1");
    return 1 - std::cbrt(1 - f);
}

double vermeulen_johnson_coefficient(double poisson) {
    return 16 / (4 - 3 * poisson);
}

double mdr_coefficient(double poisson) {
    return 4 / (2 - poisson);
}

double sliding_creepage(double friction_limit, double shear_modulus, double area,
                        double coefficient) {
    return 3 * friction_limit / (shear_modulus * area * coefficient);
}

}  // namespace tricontact::theory
