#include "theory/rolling/bed_under_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/root.h"
#include "contact/friction/radial_bound.h"
#include "theory/arguments.h"

namespace tricontact::theory {

namespace {

constexpr int table_pieces = 512;
constexpr int quadrature_points = 4096;
constexpr int law_ratio_bits = 40;

void check_law_ratio(const char* name, double value) {
    check_unit_interval("rolling under a law of friction", name, value);
}

}  // namespace

BedUnderLaw::BedUnderLaw(const contact::Case& c) {
    const auto radial = contact::RadialBound::of(table_pieces);
    const auto body = c.make_axisymmetric_indenter();
    const double a = contact::half_space_scales(c).contact_radius;
    std::vector<double> pressure = radial->pressure_under(
        [&](double x) { return body->plane_profile(x); }, a,
        std::numbers::pi / 2 * body->profile_slope(0), c.materials().effective_modulus());
    bound_ = radial->line(contact::bounds_inside(*c.friction.law(), std::move(pressure)), a);
    const double centre = bound_.back();
    for (double& b : bound_) b /= centre;
    whole_ = force_ratio(0, 1);
    friction_limit_ = whole_ * centre * a;
}

double BedUnderLaw::bound(double x) const {
    return contact::at_depth_of_chord(bound_.data(), table_pieces,
                                      std::sqrt(std::max(0., (1 - x) * (1 + x))));
}

/// 2 ∫_w^1 min(u, b) dx; x = cos t takes the root at the edge away. Midpoint rule.
double BedUnderLaw::force_ratio(double w, double u) const {
    const double end = std::acos(w);
    double sum = 0;
    for (int i = 0; i < quadrature_points; ++i) {
        const double t = end * (i + .5) / quadrature_points;
        sum += std::min(u, bound(std::cos(t))) * std::sin(t);
    }
    return 2 * sum * end / quadrature_points;
}

double BedUnderLaw::shakedown_limit(double w) const {
    check_law_ratio("w = W/a", w);
    return force_ratio(w, 1) / whole_;
}

double BedUnderLaw::amplitude_limit(double f) const {
    check_law_ratio("f = F_T/F_lim", f);
    return contact::bracketed_root([&](double w) { return shakedown_limit(w) - f; }, 0., 1., 1 - f,
                                   -f, law_ratio_bits);
}

std::optional<double> BedUnderLaw::settled_shift_ratio(double w, double f) const {
    check_law_ratio("w = W/a", w);
    check_law_ratio("f = F_T/F_lim", f);
    const double limit = shakedown_limit(w);
    if (f > limit) return {};
    return contact::bracketed_root([&](double u) { return force_ratio(w, u) / whole_ - f; }, 0.,
                                   bound(w), -f, limit - f, law_ratio_bits);
}

}  // namespace tricontact::theory
