#include "theory/rolling/body_rolling.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "contact/bodies/body_shapes.h"
#include "contact/bodies/shapes_of_revolution.h"
#include "theory/arguments.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/bed_under_law.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory {

namespace {

template <typename Function>
double integral(Function f, double low, double high) {
    thread_local boost::math::quadrature::tanh_sinh<double> quadrature;  // keeps its abscissas
    return low < high ? quadrature.integrate(f, low, high, 1e-10) : 0;
}

/// Whether there is a pressure at rho.
bool inside(double rho) {
    if (!(rho >= 0)) throw std::domain_error("pressure: r/a must not be negative");
    return rho < 1;
}

using contact::Case;

bool is_ellipsoid(const Case& c) {
    return c.indenter.shape == Case::Shape::ellipsoid;
}

constexpr int ratio_bits = 40;

/// A body of revolution in its contact on the half-space, E* = 1.
class Pressed {
  public:
    explicit Pressed(const Case& c)
        : body_(c.make_axisymmetric_indenter()),
          radius_(contact::half_space_scales(c).contact_radius),
          depth_(body_->plane_profile(radius_)),
          force_(body_->pressed_area(radius_)) {}

    /// g and P at x = rho a over d and F_N.
    double depth_ratio(double rho) const { return body_->plane_profile(rho * radius_) / depth_; }
    double force_ratio(double rho) const {
        return rho == 0 ? 0 : body_->pressed_area(rho * radius_) / force_;
    }
    double radius() const { return radius_; }

    /// f of a bed that has come to rest with the stick zone rho - w, rho >= w; falls with rho. All
    /// springs as deep as the middle one are 2 E* a d.
    double bed_force_ratio(double rho, double w) const {
        const double full = 2 * radius_ * depth_ / force_;
        return 1 - force_ratio(rho) - full * w * (1 - depth_ratio(rho));
    }
    double bed_limit(double w) const { return bed_force_ratio(w, w); }

  private:
    std::unique_ptr<contact::AxisymmetricIndenter> body_;
    double radius_, depth_, force_;
};

/// Pressure over its mean at equal distances of r/a, linear in between.
template <typename Pressure>
std::vector<double> tabulated(Pressure pressure, int n) {
    std::vector<double> table;
    for (int i = 0; i <= n; ++i) table.push_back(pressure(static_cast<double>(i) / n));
    table.push_back(0);
    return table;
}

/// What the limit lacks of the bed's where the pressure is less in the middle of the path than at
/// its end farthest from the axis: 1/F_N ∫ (p_end - p_near)_+ dA, p rising to a ring and falling
/// beyond. Midpoint rule.
template <typename Pressure>
double deficit(Pressure pressure, double w) {
    constexpr int n = 500;  // the integrand has creases: error about n^-2
    const std::vector<double> table = tabulated(pressure, 2 * n);
    auto p = [&](double rho) {
        const double place = std::min(1., rho) * 2 * n;
        const int i = static_cast<int>(place);
        return std::lerp(table[i], table[i + 1], place - i);
    };
    double sum = 0;
    for (double x = .5 / n; x < 1 - w; x += 1. / n)
        for (double y = .5 / n; std::hypot(x + w, y) < 1; y += 1. / n)
            sum += std::max(0., p(std::hypot(x + w, y)) - p(std::hypot(std::max(0., x - w), y)));
    return 4 * sum / std::numbers::pi / n / n;
}

/// 0 where the pressure falls with r; empty where it is not known.
std::optional<double> deficit_of(const Case& c, const Pressed& pressed, double w) {
    if (contact::pressure_falls(c)) return 0;
    switch (c.indenter.shape) {
        case Case::Shape::power_law:
            return deficit(
                [n = c.indenter.exponent](double rho) { return power_law_pressure(n, rho); }, w);
        case Case::Shape::rounded_punch:
            return deficit([flat = c.indenter.flat_radius / pressed.radius()](
                               double rho) { return rounded_punch_pressure(flat, rho); },
                           w);
        default:
            return {};
    }
}

/// W over an ellipse's half axis in the direction of rolling: contacts that differ by a stretch of
/// the plane have the same shares of the load.
double stretched_amplitude(const Case& c, double w) {
    const contact::HalfSpaceScales s = contact::half_space_scales(c);
    const double angle = c.rolling ? c.rolling->angle : 0;
    return w * s.contact_radius *
           std::hypot(std::cos(angle) / s.half_widths[0], std::sin(angle) / s.half_widths[1]);
}

}  // namespace

double power_law_pressure(double exponent, double rho) {
    if (!(exponent >= 1) || !std::isfinite(exponent))
        throw std::domain_error("power_law_pressure: the exponent must be at least 1");
    if (!inside(rho)) return 0;
    if (rho == 0) return exponent > 1 ? (exponent + 1) / (2 * (exponent - 1)) : contact::infinity;
    if (exponent == 1) return std::acosh(1 / rho);
    const double end = std::sqrt((1 - rho) * (1 + rho));
    auto growth = [=](double s) { return std::pow(rho * rho + s * s, exponent / 2 - 1); };
    return (exponent + 1) / 2 * integral(growth, 0, end);
}

double rounded_punch_pressure(double flat_ratio, double rho) {
    if (!(flat_ratio > 0 && flat_ratio < 1))
        throw std::domain_error("rounded_punch_pressure: b/a must lie in (0, 1)");
    if (!inside(rho)) return 0;
    const double b = flat_ratio, end = std::sqrt((1 - rho) * (1 + rho));
    auto growth = [=](double s) {
        const double x = std::hypot(rho, s), beyond = std::sqrt(std::max(0., (x - b) * (x + b)));
        return (2 * beyond - b * std::atan2(beyond, b)) / x;
    };
    const double begin = std::sqrt(std::max(0., (b - rho) * (b + rho)));
    return integral(growth, begin, end) / contact::RoundedPunch(b, 1).pressed_area(1);
}

bool has_body_theory(const Case& c) {
    return contact::is_smooth_ball(c.indenter) && !c.interface.is_elastic() && !c.friction.map &&
           !c.friction.remembers() &&
           (c.friction.is_coulomb() || (!is_ellipsoid(c) && contact::pressure_falls(c)));
}

double static_shift_ratio(const Case& c, double f) {
    check_unit_interval("rolling of a body", "f = F_T/(mu F_N)", f);
    if (!c.friction.is_coulomb()) return BedUnderLaw(c).static_shift_ratio(f);
    if (contact::is_hertz_round(c) || is_ellipsoid(c)) return static_shift_ratio(f);
    const Pressed pressed(c);
    const double stick =
        contact::bracketed_root([&](double rho) { return pressed.force_ratio(rho) - (1 - f); }, 0.,
                                1., f - 1, f, ratio_bits);
    return 1 - pressed.depth_ratio(stick);
}

std::optional<double> shakedown_limit(const Case& c, double w) {
    check_unit_interval("rolling of a body", "w = W/a", w);
    if (!c.friction.is_coulomb()) return BedUnderLaw(c).shakedown_limit(w);
    if (contact::is_hertz_round(c)) return shakedown_limit(w);
    if (is_ellipsoid(c)) return shakedown_limit(std::min(1., stretched_amplitude(c, w)));
    const Pressed pressed(c);
    const auto less = deficit_of(c, pressed, w);
    if (!less) return {};
    return pressed.bed_limit(w) - *less;
}

std::optional<double> amplitude_limit(const Case& c, double f) {
    check_unit_interval("rolling of a body", "f = F_T/(mu F_N)", f);
    if (!c.friction.is_coulomb()) return BedUnderLaw(c).amplitude_limit(f);
    if (contact::is_hertz_round(c)) return amplitude_limit(f);
    if (is_ellipsoid(c)) return amplitude_limit(f) / stretched_amplitude(c, 1);
    if (!shakedown_limit(c, 0)) return {};
    return contact::bracketed_root([&](double w) { return *shakedown_limit(c, w) - f; }, 0., 1.,
                                   1 - f, -f, ratio_bits);
}

std::optional<double> bed_settled_shift_ratio(const Case& c, double w, double f) {
    check_unit_interval("rolling of a body", "w = W/a", w);
    check_unit_interval("rolling of a body", "f = F_T/(mu F_N)", f);
    if (is_ellipsoid(c)) return {};
    if (!c.friction.is_coulomb()) return BedUnderLaw(c).settled_shift_ratio(w, f);
    if (contact::is_hertz_round(c)) return settled_shift_ratio(w, f);
    const Pressed pressed(c);
    const double limit = pressed.bed_limit(w);
    if (f > limit) return {};
    auto excess = [&](double part) {
        return f - pressed.bed_force_ratio(std::lerp(w, 1., part), w);
    };
    const double part = contact::bracketed_root(excess, 0., 1., f - limit, f, ratio_bits);
    return 1 - pressed.depth_ratio(std::lerp(w, 1., part));
}

}  // namespace tricontact::theory
