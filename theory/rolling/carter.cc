#include "theory/rolling/carter.h"

#include <cmath>
#include <stdexcept>

namespace tricontact::theory {

namespace {

/// Hertz' ellipse of half width 1.
double ellipse(double x) {
    return std::abs(x) < 1 ? std::sqrt((1 - x) * (1 + x)) : 0;
}

}  // namespace

double carter_stick_ratio(double f) {
    if (!(f >= 0 && f <= 1)) throw std::domain_error("carter: f must lie between 0 and 1");
    return std::sqrt(1 - f);
}

double carter_creepage_ratio(double f) {
    return f / (1 + carter_stick_ratio(f));  // 1 - sqrt(1 - f) without cancellation
}

double carter_force_ratio(double creepage_ratio) {
    if (!(creepage_ratio >= 0))
        throw std::domain_error("carter: the creepage must not be negative");
    return creepage_ratio < 1 ? creepage_ratio * (2 - creepage_ratio) : 1;
}

double carter_traction(double x, double f) {
    const double c = carter_stick_ratio(f);
    if (std::isnan(x)) throw std::domain_error("carter: the position is no number");
    return c > 0 ? ellipse(x) - c * ellipse((x - 1 + c) / c) : ellipse(x);
}

}  // namespace tricontact::theory
