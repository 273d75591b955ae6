#include "contact/bodies/power_law.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/error.h"

namespace tricontact::contact {

double power_law_factor(double n) {
    if (!(n >= 1) || !std::isfinite(n))
        throw std::domain_error("power_law_factor: the exponent must be at least 1");
    // Gamma overflows beyond 171: logarithms
    const double ratio = std::exp(std::lgamma(n / 2) - std::lgamma((n + 1) / 2));
    return n * std::sqrt(std::numbers::pi) / 2 * ratio;
}

PowerLaw::PowerLaw(double coefficient, double exponent)
    : coefficient_(coefficient), exponent_(exponent) {
    if (!(coefficient > 0) || !std::isfinite(coefficient))
        throw InputError("indenter: the coefficient of a power law must be positive and finite");
    if (!(exponent >= 1) || !std::isfinite(exponent))
        throw InputError("indenter: the exponent of a power law must be at least 1");
}

double PowerLaw::profile(double r) const {
    return coefficient_ * std::pow(r, exponent_);
}

double PowerLaw::profile_slope(double r) const {
    return coefficient_ * exponent_ * std::pow(r, exponent_ - 1);
}

double PowerLaw::outer_radius() const {
    return std::numeric_limits<double>::infinity();
}

double PowerLaw::slope_moment(double x, int k) const {
    const double mean_slope =
        coefficient_ * power_law_factor(exponent_) * std::pow(x, exponent_ - 1);
    return k == 0 ? mean_slope : exponent_ / (exponent_ + 1) * x * x * mean_slope;
}

double PowerLaw::centre_pressure(double x) const {
    if (exponent_ == 1) return std::numeric_limits<double>::infinity();
    return exponent_ / (exponent_ - 1) * slope_moment(x, 0) / std::numbers::pi;
}

}  // namespace tricontact::contact
