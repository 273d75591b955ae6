#include "theory/thesis_cylinder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "theory/arguments.h"
#include "theory/bracketed_root.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

void check_thesis_zones(double w, double c) {
    check_unit_interval("thesis' cylinder", "w = W/a", w);
    if (!(c >= 0 && c < 1 - w))
        throw std::domain_error("thesis' cylinder: c = c_sd/a must lie in [0, 1 - w)");
}

double semi_ellipse(double x, double half_width) {
    return std::sqrt(std::max(0., (half_width - x) * (half_width + x))) / half_width;
}

}  // namespace

double thesis_line_traction(double x, double w, double c) {
    check_thesis_zones(w, c);
    const double distance = std::abs(x), b = 1 - w;
    if (distance >= b) return 0;
    if (distance >= c) return semi_ellipse(distance + w, 1);
    const double t21 = semi_ellipse(c + w, 1) / semi_ellipse(c, b);
    return t21 * semi_ellipse(distance, b) - t21 * c / b * semi_ellipse(distance, c);
}

double thesis_line_stick_force(double w, double c) {
    check_thesis_zones(w, c);
    const double sum = c + w, b = 1 - w, k = c / b;
    const double stick = b * (std::asin(k) - k * k * pi / 2) / std::sqrt((1 - k) * (1 + k));
    return 2 / pi * (std::acos(sum) + semi_ellipse(sum, 1) * (stick - w));
}

std::optional<double> thesis_line_stick_half_width(double w, double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    if (f > line_shakedown_limit(w)) return std::nullopt;
    if (thesis_line_stick_force(w, 0) <= f) return 0.;
    const auto excess = [&](double c) {
        return c < 1 - w ? thesis_line_stick_force(w, c) - f : -f;
    };
    return bracketed_root(excess, 0., 1 - w);
}

double thesis_line_static_shift_ratio(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return 1 - std::pow(1 - f, 0.92);
}

double thesis_line_unit_shift(const contact::MaterialPair& materials, double friction_coefficient,
                              double load, double length_ratio) {
    const double e_star = materials.effective_modulus();
    return friction_coefficient * 2 * load / (pi * e_star) *
           ((1 + std::log(4.)) / 2 +
            std::log(1.8 * e_star / materials.effective_shear_modulus() * length_ratio));
}

std::optional<double> thesis_line_settled_shift_ratio(double w, double f) {
    if (f > line_shakedown_limit(w)) return std::nullopt;
    return thesis_line_static_shift_ratio(f) + 0.3 * f * w;
}

double thesis_line_amplitude_limit(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return 1 - std::pow(f, 0.73);
}

double thesis_line_limit_shift_ratio(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return std::pow(f, 0.87);
}

double thesis_line_increment(double w, double f) {
    check_unit_interval("thesis' cylinder", "w = W/a", w);
    return 0.64 * f * std::max(0., w - thesis_line_amplitude_limit(f));
}

}  // namespace tricontact::theory
