#include "theory/rolling/mapped_strength.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "contact/base/root.h"
#include "theory/arguments.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

double strength_limit_of(double w) {
    return strength_rolling.exact_limit(w);
}

/// (1 - n sqrt(1 - w)): the lens is the less round the wider the path, and its ends are not on it.
double oriented(const MappedRolling& p) {
    return 1 - orientation(p) / 3 * std::sqrt(1 - p.amplitude_ratio);
}

/// Of small loads.
double least_mapping(const MappedRolling& p) {
    if (p.amplitude_ratio == 0) return small_amplitude_strength_mapping(p, 0);
    return small_load_mapping(p.amplitude_ratio, strength_rolling) * oriented(p);
}

}  // namespace

double small_amplitude_strength_mapping(const MappedRolling& p, double u) {
    check(p);
    check_unit_interval("mapped rolling", "u = U/U_max", u);
    const double n = orientation(p) / 3;
    const double ratio = u == 0 ? 1 : std::asin(u) / u;
    return 8 / (pi * pi) * (ratio - n * std::sqrt((1 - u) * (1 + u)));
}

double largest_strength_shift_ratio(const MappedRolling& p) {
    check(p);
    const double w = p.amplitude_ratio;
    const auto ray = [&](double phi) {
        const double length = std::sqrt(1 - std::pow(w * std::sin(phi), 2)) - w * std::cos(phi);
        return length * (1 + orientation(p) * std::cos(2 * phi));
    };
    return 2 / pi * boost::math::quadrature::gauss<double, 30>::integrate(ray, 0., pi / 2);
}

double strength_mapping(const MappedRolling& p) {
    check(p);
    const double w = p.amplitude_ratio, least = least_mapping(p);
    if (w == 0) return least;
    const double limit = strength_limit_of(w);
    const double share = std::min(1., p.tangential_ratio / limit);
    const double most =
        strength_rolling.mapping_parameter(w, limit, largest_strength_shift_ratio(p));
    return most - (most - least) * std::pow(1 - share * share, .18 + .36 * std::sqrt(w));
}

std::optional<double> strength_settled_shift_ratio(const MappedRolling& p) {
    const double kappa = strength_mapping(p);
    if (p.tangential_ratio > strength_limit_of(p.amplitude_ratio)) return std::nullopt;
    return strength_rolling.settled_shift_ratio(p.amplitude_ratio, p.tangential_ratio, kappa);
}

}  // namespace tricontact::theory
