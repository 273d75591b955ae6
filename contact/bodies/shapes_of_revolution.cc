#include "contact/bodies/shapes_of_revolution.h"

#include <algorithm>
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

RoundedPunch::RoundedPunch(double flat_radius, double radius)
    : flat_radius_(flat_radius), radius_(radius) {
    if (!(flat_radius > 0) || !std::isfinite(flat_radius) || !(radius > 0) ||
        !std::isfinite(radius))
        throw InputError("indenter: both radii of a rounded punch must be positive and finite");
}

double RoundedPunch::profile(double r) const {
    const double beyond = std::max(0., r - flat_radius_);
    return beyond * beyond / (2 * radius_);
}

double RoundedPunch::profile_slope(double r) const {
    return std::max(0., r - flat_radius_) / radius_;
}

double RoundedPunch::outer_radius() const {
    return std::numeric_limits<double>::infinity();
}

double RoundedPunch::slope_moment(double x, int k) const {
    if (x <= flat_radius_) return 0;
    return (arc_moment(x, flat_radius_, x, k + 1) -
            flat_radius_ * arc_moment(x, flat_radius_, x, k)) /
           radius_;
}

}  // namespace tricontact::contact
