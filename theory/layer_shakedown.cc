#include "theory/layer_shakedown.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tricontact::theory {

namespace {

void check_unit_interval(const char* name, double value) {
    if (!(value >= 0 && value <= 1))
        throw std::domain_error("shakedown on a layer: " + std::string(name) +
                                " must lie in [0, 1]");
}

}  // namespace

double shakedown_limit(const LayerContact& contact, double w) {
    check_unit_interval("w = W/a", w);
    const double a = contact.contact_radius;
    return 1 - contact.line_load.integral(w * a) / contact.line_load.integral(a);
}

double amplitude_limit(const LayerContact& contact, double f) {
    check_unit_interval("f = F_T/(mu F_N)", f);
    if (f == 0 || f == 1) return 1 - f;
    const auto excess = [&](double w) { return shakedown_limit(contact, w) - f; };
    std::uintmax_t evaluations = 200;  // toms748 needs about 10
    const auto [left, right] = boost::math::tools::toms748_solve(
        excess, 0., 1., 1 - f, -f, boost::math::tools::eps_tolerance<double>(50), evaluations);
    return std::midpoint(left, right);
}

}  // namespace tricontact::theory
