#include "theory/rolling/free_rolling.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/bracketed_root.h"

namespace tricontact::theory {

namespace {

/// Of a rigid body on one with nu = -1; 1/2 bounds beta for nu >= 0 alone.
constexpr double largest_beta = .75;

void check(double beta) {
    if (!(std::abs(beta) <= largest_beta))
        throw std::domain_error("free rolling: Dundurs' beta must lie between -3/4 and 3/4");
}

}  // namespace

double rough_free_creepage(double beta) {
    check(beta);
    const double e = std::atanh(beta) / std::numbers::pi;
    return 2 * e / std::sqrt(1 + 4 * e * e);
}

double smooth_free_creepage(double beta) {
    check(beta);
    // |x| < y a carries half of Hertz' load: (2/pi) (asin y + y sqrt(1 - y^2)) = 1/2.
    const double y = bracketed_root(
        [](double s) {
            return std::asin(s) + s * std::sqrt((1 - s) * (1 + s)) - std::numbers::pi / 4;
        },
        0, 1);
    return beta * std::sqrt((1 - y) * (1 + y));
}

double thin_layer_smooth_creepage(double poisson) {
    if (!(poisson > -1 && poisson < .5))
        throw std::domain_error("free rolling: Poisson's ratio must lie between -1 and 1/2");
    return (1 - 4 * poisson) / (2 * (1 - 2 * poisson));
}

}  // namespace tricontact::theory
