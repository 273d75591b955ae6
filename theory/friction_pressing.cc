#include "theory/friction_pressing.h"

#include <cmath>
#include <stdexcept>

#include "contact/base/root.h"

namespace tricontact::theory {

double spence_stick_ratio(double beta_over_mu) {
    if (!(beta_over_mu > 0 && std::isfinite(beta_over_mu)))
        throw std::domain_error("spence_stick_ratio: beta/mu must be positive");
    const auto excess = [&](double c) {
        return beta_over_mu * std::atanh(c) / c - std::comp_ellint_1(std::sqrt(1 - c * c));
    };
    // Beyond, 1 - c^2 is rounded: beta/mu above 17 slips but for 1e-7 of the radius, below 0.09
    // the edge alone does.
    constexpr double least = 1e-7, most = 1 - 1e-15;
    if (excess(least) >= 0) return least;
    if (excess(most) <= 0) return most;
    return contact::bracketed_root(excess, least, most, 48);
}

double stuck_normal_stiffness_ratio(double poisson) {
    if (!(poisson > -1 && poisson < .5))
        throw std::domain_error("stuck_normal_stiffness_ratio: nu must be in (-1, 1/2)");
    return std::log1p(2 * (1 - 2 * poisson)) / (1 - 2 * poisson);
}

}  // namespace tricontact::theory
