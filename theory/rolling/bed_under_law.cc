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
constexpr int angle_pieces = 1024;
constexpr int law_ratio_bits = 40;
constexpr double middle = std::numbers::pi / 2, angle_step = middle / angle_pieces;

void check_law_ratio(const char* name, double value) {
    check_unit_interval("rolling under a law of friction", name, value);
}

/// Simpson's rule.
template <typename Function>
double piece(Function f, double from, double to) {
    return (to - from) / 6 * (f(from) + 4 * f((from + to) / 2) + f(to));
}

}  // namespace

BedUnderLaw::BedUnderLaw(const contact::Case& c) {
    if (contact::is_hertz_round(c)) {
        round_.emplace(c);
        friction_limit_ = round_->friction_limit();
        whole_ = static_force(middle);
        return;
    }
    const auto radial = contact::RadialBound::of(table_pieces);
    const auto body = c.make_axisymmetric_indenter();
    const double a = contact::half_space_scales(c).contact_radius;
    std::vector<double> pressure = radial->pressure_under(
        [&](double x) { return body->plane_profile(x); }, a,
        std::numbers::pi / 2 * body->profile_slope(0), c.materials().effective_modulus());
    bound_ = radial->line(contact::bounds_inside(*c.friction.law(), std::move(pressure)), a);
    const double centre = bound_.back();
    for (double& b : bound_) b /= centre;
    beyond_.push_back(0);
    for (int i = 0; i < angle_pieces; ++i)
        beyond_.push_back(beyond_.back() + piece([&](double t) { return bound(t) * std::sin(t); },
                                                 i * angle_step, (i + 1) * angle_step));
    whole_ = static_force(middle);
    friction_limit_ = whole_ * centre * a;
}

double BedUnderLaw::bound(double angle) const {
    if (round_) return round_->bound_ratio(angle);
    return contact::at_depth_of_chord(bound_.data(), table_pieces, std::sin(angle));
}

/// x = cos t takes the root at the edge away.
double BedUnderLaw::beyond(double angle) const {
    const auto i =
        std::min<std::size_t>(angle_pieces - 1, static_cast<std::size_t>(angle / angle_step));
    return beyond_[i] + piece([&](double t) { return bound(t) * std::sin(t); },
                              static_cast<double>(i) * angle_step, angle);
}

double BedUnderLaw::static_force(double angle) const {
    if (round_) return round_->force_ratio(angle);
    return 2 * (std::cos(angle) * bound(angle) + beyond(angle));
}

/// 2 ∫_w^1 min(u, b) dx over the whole, u = b at the edge of stick, which lies beyond w.
double BedUnderLaw::rolled_force(double w, double angle) const {
    return (static_force(angle) - 2 * w * bound(angle)) / whole_;
}

double BedUnderLaw::shakedown_limit(double w) const {
    check_law_ratio("w = W/a", w);
    return rolled_force(w, std::acos(w));
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
    const double angle = contact::bracketed_root([&](double t) { return rolled_force(w, t) - f; },
                                                 0., std::acos(w), -f, limit - f, law_ratio_bits);
    return bound(angle);
}

}  // namespace tricontact::theory
