#include "theory/rolling/soft_interface.h"

#include <cmath>
#include <numbers>

#include "theory/arguments.h"

namespace tricontact::theory {

namespace {

// Of the pressures 1 - r^2 what two contacts share whose centres are 2 w apart, over its integral
// pi/2: 16/(3 pi) times the integral of (1 - s^2)^(3/2) over s from w to 1.
double shared_part(double w) {
    if (w >= 1) return 0;
    return 1 - 2 / std::numbers::pi *
                   (w * std::sqrt((1 - w) * (1 + w)) * (5 - 2 * w * w) / 3 + std::asin(w));
}

void check_ratio(const char* what, double value) {
    check_unit_interval("contact on a soft interface", what, value);
}

}  // namespace

double soft_interface_force(double u) {
    check_ratio("u = k_t U/(mu k_n d)", u);
    return u * (2 - u);
}

double soft_interface_limit(double w) {
    check_ratio("w = W/a", w);
    return shared_part(w);
}

double soft_interface_settled_force(double w, double u) {
    check_ratio("w = W/a", w);
    check_ratio("u = k_t U/(mu k_n d)", u);
    const double left = 1 - u;
    return shared_part(w) - (left > 0 ? left * left * shared_part(w / std::sqrt(left)) : 0);
}

double soft_interface_creep_force(double theta) {
    check_ratio("theta = k_t xi a/(2 mu k_n d)", theta);
    return 1 - (1 - theta) * (1 - theta) * (1 - theta);
}

}  // namespace tricontact::theory
